/// Islands: groups of cubes that touch one another or that rods join. Each is a program of its own;
/// cubes without contacts and rods need none.
#pragma once

#include <vector>

#include "core/constraints/contact.h"

namespace wuerfel {

struct Island {
  std::vector<int> cubes;         ///< ascending
  std::vector<Contact> contacts;  ///< of these cubes with one another and with what is fixed
  std::vector<Touch> touches{};   ///< of these contacts, where they were asked for
  std::vector<int> rods{};        ///< of these cubes: numbers in System::rods, ascending
  /// m, per rod: what its length has come to miss beyond the first order in a placement; empty: nothing.
  std::vector<double> bends{};
};

/// Per cube the number of its island, in the order of their first cubes; -1: it is free. Islands are joined by rods and
/// by pairs of bodies.
std::vector<int> number_islands(const System& system, std::span<const IndexPair> joined_bodies);

/// Cubes joined by contacts and rods, in the order of their first cube; free cubes belong to no island. With the `touches` that
/// the contacts belong to, where they are given.
std::vector<Island> find_islands(const System& system,
                                 std::span<const Contact> contacts,
                                 std::span<const Touch> touches = {});

/// All cubes, free ones too, and all contacts as one island: what islands are compared with.
Island one_island(const System& system, const std::vector<Contact>& contacts);

/// Adds an island for each cube that is in none.
void add_free_cubes(const System& system, std::vector<Island>& islands);

/// Whether a fixed body takes part in one of the contacts.
bool touches_fixed(const System& system, std::span<const Contact> contacts);
/// Whether a contact or a rod joins an island to something fixed.
bool is_fixed(const System& system, const Island& island);

/// Whether all cubes of an island rest (`resting`: one per cube).
bool all_rest(const Island& island, const std::vector<char>& resting);

}  // namespace wuerfel
