/// The door of the Ipopt module: plain data in, plain data out, so that nothing of Ipopt is seen
/// outside.
#pragma once

#include <cstdint>

namespace wuerfel {

/// minimise 1/2 |y|^2 + cost' e  subject to  lower <= G y + S e <= upper,  e >= 0, where the
/// elastic unknowns e follow the `unknowns` entries of y. The arrays live with the caller.
struct IpoptProgram {
  std::int32_t unknowns = 0;  ///< of y
  std::int32_t elastics = 0;  ///< of e
  std::int32_t rows = 0;
  std::int32_t entries = 0;              ///< of [G S]
  const double* cost = nullptr;          ///< elastics
  const double* lower = nullptr;         ///< rows; -1e20 and below: none
  const double* upper = nullptr;         ///< rows; +1e20 and above: none
  const std::int32_t* row = nullptr;     ///< entries
  const std::int32_t* column = nullptr;  ///< entries
  const double* value = nullptr;         ///< entries
};

struct IpoptPoint {
  double* y = nullptr;           ///< unknowns + elastics
  double* multiplier = nullptr;  ///< rows, in the sign of y = G' multiplier
  std::int32_t iterations = 0;
  bool infeasible = false;  ///< Ipopt ended at the least violation of the rows
};

/// How the barrier parameter falls: from Ipopt's start, or from farther away.
enum class IpoptBarrier { monotone, adaptive, far };

/// What ipopt_module_open returns; one per solver object.
class IpoptSession {
 public:
  IpoptSession() = default;
  IpoptSession(const IpoptSession&) = delete;
  IpoptSession& operator=(const IpoptSession&) = delete;
  virtual ~IpoptSession() = default;
  /// False if Ipopt gave no point at all. How good the point is must be judged by the caller.
  virtual bool solve(const IpoptProgram& program, IpoptBarrier barrier, IpoptPoint& point) = 0;
};

inline constexpr const char* ipopt_module_file = "libwuerfel_ipopt.so";
inline constexpr const char* ipopt_module_symbol = "wuerfel_open_ipopt";
/// Signature of the exported function; the caller owns the session. Null if Ipopt refuses to start.
using OpenIpopt = IpoptSession* (*)();

}  // namespace wuerfel
