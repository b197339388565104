#include "render/picture/units.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace wuerfel::internal {
namespace {

struct Prefix {
  double factor;
  std::string_view name;
};

constexpr std::array<Prefix, 10> prefixes{{{1e15, "P"},
                                           {1e12, "T"},
                                           {1e9, "G"},
                                           {1e6, "M"},
                                           {1e3, "k"},
                                           {1.0, ""},
                                           {1e-3, "m"},
                                           {1e-6, "µ"},
                                           {1e-9, "n"},
                                           {1e-12, "p"}}};

/// The prefix of numbers of this size; none for 0 and beyond the prefixes.
Prefix prefix_of(double size) {
  const auto fits = [size](const Prefix& p) { return size >= p.factor * (1.0 - 1e-9); };
  const auto found = std::ranges::find_if(prefixes, fits);
  const bool beyond = found == prefixes.end() || size >= 1e18;
  return beyond ? Prefix{1.0, ""} : *found;
}

Prefix prefix_of_energy(double size) {
  constexpr double shown_as_joule = 1e4;
  return size >= 1.0 && size < shown_as_joule ? Prefix{1.0, ""} : prefix_of(size);
}

/// A sign as it is printed, and none where nothing but zeros is told.
std::string signed_text(const std::string& text) {
  if (!text.starts_with('-')) return text;
  const std::string size = text.substr(1);
  return size.find_first_of("123456789") == std::string::npos ? size : "−" + size;
}

int decimals_of_energy(double of_prefix) {
  return of_prefix >= 1000.0 ? 0 : of_prefix >= 100.0 ? 1 : 2;
}

}  // namespace

std::string with_prefix(double value, std::string_view unit, int digits, Zeros zeros) {
  // 999.9 N to three digits is 1 kN.
  const Prefix prefix = prefix_of(std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -digits)));
  const double of_prefix = value / prefix.factor;
  if (of_prefix == 0.0) return fmt::format("0 {}", unit);
  const std::string scientific = fmt::format("{:.{}e}", of_prefix, digits - 1);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  if (zeros == Zeros::dropped) {
    const double last = std::pow(10.0, exponent - digits + 1);
    return fmt::format("{:.10g} {}{}", std::round(of_prefix / last) * last, prefix.name, unit);
  }
  // Beyond the prefixes as with zeros dropped.
  if (exponent >= 6 || exponent < -4) return fmt::format("{} {}{}", scientific, prefix.name, unit);
  return fmt::format("{:.{}f} {}{}", of_prefix, std::max(digits - 1 - exponent, 0), prefix.name,
                     unit);
}

std::string length_label(double metres) {
  if (metres < 1.0 && metres >= 0.01 * (1.0 - 1e-9))
    return fmt::format("{:.6g} cm", 100.0 * metres);
  return with_prefix(metres, "m");
}

std::string energy_label(double joule, double size) {
  const double about = std::max(std::abs(joule), size);
  const Prefix prefix = prefix_of_energy(about);
  const double of_prefix = about / prefix.factor;
  if (of_prefix > 1e5 || (about > 0.0 && of_prefix < 1e-3))
    return signed_text(fmt::format("{:.3g} J", joule));
  return signed_text(fmt::format("{:.{}f} {}J", joule / prefix.factor,
                                 decimals_of_energy(of_prefix), prefix.name));
}

std::string energy_change_label(double joule, double size) {
  const double about = std::abs(joule);
  const Prefix prefix = prefix_of_energy(std::max(about, size));
  const double of_prefix = about / prefix.factor;
  if (of_prefix > 1e5 || of_prefix < 1e-3)
    return fmt::format("{:.3g} {}J", joule / prefix.factor, prefix.name);
  const int decimals = of_prefix < 1.0 ? 2 - static_cast<int>(std::floor(std::log10(of_prefix)))
                                       : decimals_of_energy(of_prefix);
  return fmt::format("{:.{}f} {}J", joule / prefix.factor, decimals, prefix.name);
}

std::string time_label(double t, double interval) {
  constexpr int finest = 9;
  int decimals = 3;
  const auto told = [&](double value) {
    const double unit = std::pow(10.0, -decimals);
    return std::abs(value - unit * std::round(value / unit)) <= 1e-6 * unit;
  };
  if (interval > 0.0) {
    while (decimals < finest && interval < 2.0 * std::pow(10.0, -decimals))
      ++decimals;
  } else {
    while (decimals < finest && !told(t) && t < 1.0)
      ++decimals;
  }
  return fmt::format("{:.{}f} s", t, decimals);
}

}  // namespace wuerfel::internal
