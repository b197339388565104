/// Numbers as people read them.
#pragma once

#include <string>
#include <string_view>

namespace wuerfel::internal {

/// Whether "2.00 kN" is "2 kN".
enum class Zeros { dropped, kept };

/// "2 kN" for 2000 and "N": to `digits` significant ones, with the prefix from p to P that makes it
/// easy to read.
std::string with_prefix(double value,
                        std::string_view unit,
                        int digits = 6,
                        Zeros zeros = Zeros::dropped);

/// Centimetres are what people use between a millimetre and a metre.
std::string length_label(double metres);

/// Energy to a thousandth of `size`, so that the digits stand still while it changes.
std::string energy_label(double joule, double size);

/// Three digits of a change beside an energy of such a `size`, with its prefix.
std::string energy_change_label(double joule, double size);

/// Seconds to the millisecond, or finer where frames `interval` s apart, or the time itself, need it.
std::string time_label(double t, double interval);

}  // namespace wuerfel::internal
