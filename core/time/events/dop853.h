/// The embedded Runge-Kutta method of order 8 with error estimates of orders 5 and 3 and dense
/// output of order 7: DOP853 of Dormand and Prince
/// [Hairer, Norsett, Wanner 1993, II.10].
#pragma once

#include <array>
#include <vector>

namespace wuerfel {

/// One step as a polynomial in the share s of the step, 0 <= s <= 1.
class DenseStep {
 public:
  static constexpr int terms = 8;
  /// Component i at the share s.
  [[nodiscard]] double component(double s, std::size_t i) const {
    const double* c = &coefficients[i * terms];
    const double r = 1.0 - s;
    return c[0]
           + s * (c[1] + r * (c[2] + s * (c[3] + r * (c[4] + s * (c[5] + r * (c[6] + s * c[7]))))));
  }
  /// Derivative of component i by s.
  [[nodiscard]] double slope(double s, std::size_t i) const {
    const double* c = &coefficients[i * terms];
    const double r = 1.0 - s;
    double value = c[7];
    double rate = 0.0;
    for (int k = 6; k >= 1; --k) {
      const bool falls = k % 2 != 0;  // the factor is r
      rate = falls ? r * rate - value : s * rate + value;
      value = c[k] + (falls ? r : s) * value;
    }
    return s * rate + value;
  }

  std::vector<double> coefficients;  ///< `terms` for each component
};

/// Takes steps of y' = f(y) and keeps its stages from step to step. A `Field` is called with y and
/// the vector of rates to be filled, both of the same size.
class Dop853 {
 public:
  static constexpr int stages = 12;

  /// A step of length h from `y`, where `rate` = f(y). The result is `next()`.
  template <typename Field>
  void step(Field&& field,
            const std::vector<double>& y,
            const std::vector<double>& rate,
            double h) {
    begin(rate, h);
    for (int i = 1; i < stages; ++i)
      field(stage_state(i, y), k_[i]);
    end(y);
  }
  [[nodiscard]] const std::vector<double>& next() const { return next_; }
  /// Error estimate of the last step relative to `scale` (same size as the state), largest
  /// component; at most 1 where the step may be accepted for a tolerance of 1.
  [[nodiscard]] double error(const std::vector<double>& scale) const;
  /// The last step as a polynomial; `next_rate` = f(next()). Three more evaluations.
  template <typename Field>
  void dense(Field&& field,
             const std::vector<double>& y,
             const std::vector<double>& next_rate,
             DenseStep& result) {
    k_[stages] = next_rate;
    for (int i = stages + 1; i < evaluations; ++i)
      field(stage_state(i, y), k_[i]);
    interpolate(y, result);
  }
  /// The weights of the stages in `next()`.
  static const std::array<double, stages> stage_weights;
  /// Rates at the stages of the last step, in the order of the method.
  [[nodiscard]] const std::vector<double>& stage(int i) const { return k_[i]; }

  /// The stages, f(next), and three for dense output.
  static constexpr int evaluations = stages + 4;

 private:
  void begin(const std::vector<double>& rate, double h);
  /// y of stage i, counted from 0, from the stages before it.
  const std::vector<double>& stage_state(int i, const std::vector<double>& y);
  void end(const std::vector<double>& y);
  void interpolate(const std::vector<double>& y, DenseStep& result) const;

  std::array<std::vector<double>, evaluations> k_;
  std::vector<double> y_;
  std::vector<double> next_;
  double h_ = 0.0;
};

}  // namespace wuerfel
