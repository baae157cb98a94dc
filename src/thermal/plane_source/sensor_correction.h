#pragma once

/// What the insulation of a sensor adds to its readings (thesis section 5.2.2; theory T.8 to T.10).
namespace repose::thermal {

/// A figure with its standard deviation.
struct Measured {
  double value = 0.0;
  double deviation = 0.0;
};

/// |value/reference - 1| in percent.
double error_percent(double value, double reference);

/// The errors that are possible when value and reference were rounded, each by at most half a unit of its last digit.
struct ErrorInterval {
  double low = 0.0;   ///< percent
  double high = 0.0;  ///< percent
  /// Whether an error that was itself rounded, by at most `half_unit` in percent, can be one of them.
  bool allows(double error, double half_unit) const { return low - half_unit <= error && error <= high + half_unit; }
};
ErrorInterval possible_errors(double value, double reference, double half_unit);

/// What mica adds to a reading: the difference to kapton at room temperature (T.8), readings independent.
Measured sensor_bias(const Measured& mica, const Measured& kapton);

/// A reading with mica at temperature without the bias, the three readings independent (T.9, T.10).
Measured corrected(const Measured& reading, const Measured& bias);

}  // namespace repose::thermal
