/// Modes and forces of contacts from one program to the next.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

class ContactMemory {
 public:
  /// Those of the contacts that were there in one of the last programs: found by their keys, or, without keys, all of
  /// them if there are as many units as before. Others keep the modes given, and no force. Forces grow as `force_unit` does.
  /// False if nothing was remembered.
  bool recall(const ContactForm& form,
              std::span<const std::uint64_t> keys,
              double force_unit,
              std::vector<ContactMode>& modes,
              std::vector<Pair>& l) const;
  void remember(std::span<const std::uint64_t> keys,
                double force_unit,
                const std::vector<ContactMode>& modes,
                const std::vector<Pair>& l);
  void forget() {
    units_.clear();
    keyed_ = 0;
  }

 private:
  struct Unit {
    std::uint64_t key = 0;
    ContactMode mode = ContactMode::open;
    Pair l;
    int age = 0;  ///< programs since it was there
  };
  [[nodiscard]] const Unit* find(int unit, std::span<const std::uint64_t> keys) const;
  void merge(std::span<const std::uint64_t> keys,
             const std::vector<ContactMode>& modes,
             const std::vector<Pair>& l);

  std::vector<Unit> units_;  ///< by key, those without one behind
  std::vector<Unit> next_;   ///< scratch
  int keyed_ = 0;
  double force_unit_ = 0.0;  ///< of the last program
};

}  // namespace wuerfel
