#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"
#include "files/read_file.h"

namespace repose {

/// Particles with diameters from `low` to `high` (m). Inside a bin the share is spread evenly over the diameter; one of
/// a single diameter has low == high.
struct SizeBin {
  double low;
  double high;
  double share;  ///< of the mass or of the number
};

/// A distribution of particle diameters: bins from small to large, which may leave gaps. Its quantiles take the basic
/// operations and square roots only, so their bits are the same on every machine.
class SizeDistribution {
 public:
  /// Shares of any positive sum; bins without a share are dropped.
  SizeDistribution(Weighting by, const std::vector<SizeBin>& bins);

  /// The diameter (m) below which the share u of the number of particles lies, 0 <= u < 1: the diameter of a particle
  /// drawn at random when u is uniform.
  double quantile(double u) const;
  /// The diameter (m) below which the share u of the mass lies, 0 <= u < 1.
  double mass_quantile(double u) const;
  double mean() const { return mean_; }           ///< mean diameter of the particles, m
  double mean_volume() const { return volume_; }  ///< of a particle, m^3
  double smallest() const { return bins_.front().low; }
  double largest() const { return bins_.back().high; }
  bool is_discrete() const;
  const std::vector<SizeBin>& bins() const { return bins_; }
  /// The share of the mass in each bin.
  std::vector<double> mass_shares() const;

 private:
  Weighting by_;
  std::vector<SizeBin> bins_;
  std::vector<double> number_;  ///< cumulative share of the number at the end of each bin
  std::vector<double> mass_;    ///< cumulative share of the mass
  double mean_ = 0.0;
  double volume_ = 0.0;
};

/// The distribution that a block of particles asks for: its [particles.sizes], or a single diameter without that
/// section. `read_file` gives the text of a csv. DeckError, beginning with `block` or as `file:line: what`, when it is
/// empty between its ends.
SizeDistribution make_size_distribution(const ParticlesDeck& particles, const ReadFile& read_file,
                                        const std::string& block);

}  // namespace repose
