#pragma once

namespace repose {

/// The scale on which an observable's surface is built, chosen such that the scatter of runs is the same everywhere.
/// `square_root` is for counts: sqrt(n + 3/8) of a Poisson count has a variance of about 1/4 whatever its mean
/// (Anscombe 1948, doi:10.1093/biomet/35.3-4.246).
enum class Transform { none, square_root, logarithm };

/// A value on the scale; NaN where it has none (counts below -3/8, logarithms of 0 and less).
double transformed(Transform transform, double value);

/// The mean of values whose transformed ones have this mean and this variance (C.9): exact for `none` and
/// `square_root`, for a normal scatter for `logarithm`. The mean of roots is not the root of the mean.
double mean_in_units(Transform transform, double mean, double variance);

/// The mean of transformed values whose own mean is `value`: the inverse of `mean_in_units`.
double transformed_mean(Transform transform, double value, double variance);

/// What a small deviation in units is on the scale, at a mean of the transformed values: d(scale) / d(units).
double slope_of_transform(Transform transform, double mean, double variance);

}  // namespace repose
