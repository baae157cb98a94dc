#include "photo/subject.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "base/error.h"

namespace repose::photo {
namespace {

using Polynomial = Eigen::Vector<double, 6>;

constexpr double most_samples = 40000.0;
constexpr double least_noise = 1.0 / 255.0;
constexpr int rounds = 12;
constexpr double deviation_of_median = 1.4826;  // standard deviation over the median of absolute deviations

struct Sample {
  Polynomial terms;
  double grey = 0.0;
};

/// The terms of the polynomial at a pixel, with x and y from -1 to 1.
Polynomial terms_at(const Image& image, double column, double row) {
  const double x = 2.0 * column / static_cast<double>(image.width) - 1.0;
  const double y = 2.0 * row / static_cast<double>(image.height) - 1.0;
  return {1.0, x, y, x * x, x * y, y * y};
}

bool is_above(const Image& image, std::size_t x, std::size_t y) {
  const auto w = static_cast<double>(image.width);
  const auto h = static_cast<double>(image.height);
  const auto u = static_cast<double>(x);
  const auto v = static_cast<double>(y);
  return v < 0.08 * h || (v < 0.4 * h && (u < 0.08 * w || u > 0.92 * w));
}

std::vector<Sample> samples_of(const Image& image) {
  const auto pixels = static_cast<double>(image.width) * static_cast<double>(image.height);
  const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(pixels / most_samples)));
  std::vector<Sample> samples;
  for (std::size_t y = step / 2; y < image.height; y += step) {
    for (std::size_t x = step / 2; x < image.width; x += step) {
      samples.push_back({terms_at(image, static_cast<double>(x), static_cast<double>(y)), image.at(x, y)});
    }
  }
  return samples;
}

Polynomial fit(const std::vector<const Sample*>& chosen, Eigen::Index degree_terms) {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(degree_terms, degree_terms);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(degree_terms);
  for (const Sample* s : chosen) {
    const Eigen::VectorXd t = s->terms.head(degree_terms);
    normal += t * t.transpose();
    right += s->grey * t;
  }
  Polynomial result = Polynomial::Zero();
  result.head(degree_terms) = normal.completeOrthogonalDecomposition().solve(right);
  return result;
}

struct Background {
  Polynomial polynomial;
  double noise = least_noise;
};

double deviation_about(const std::vector<const Sample*>& chosen, const Polynomial& polynomial) {
  std::vector<float> off;
  for (const Sample* s : chosen) off.push_back(static_cast<float>(std::abs(s->grey - polynomial.dot(s->terms))));
  return std::max(least_noise, deviation_of_median * static_cast<double>(median(off)));
}

/// Begins with what is known to be background, or with the grey value that most pixels are near, and takes in what
/// agrees: a level first, then a slope, then a curvature, so that what stands out bends nothing.
Background fit_background(const Image& image, Ground ground) {
  const std::vector<Sample> samples = samples_of(image);
  std::vector<const Sample*> chosen;
  if (ground == Ground::above) {
    const auto pixels = static_cast<double>(image.width) * static_cast<double>(image.height);
    const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(pixels / most_samples)));
    std::size_t i = 0;
    for (std::size_t y = step / 2; y < image.height; y += step) {
      for (std::size_t x = step / 2; x < image.width; x += step, ++i) {
        if (is_above(image, x, y)) chosen.push_back(&samples[i]);
      }
    }
  }
  if (chosen.empty()) {
    for (const Sample& s : samples) chosen.push_back(&s);
  }
  Background result;
  std::vector<float> greys;
  for (const Sample* s : chosen) greys.push_back(static_cast<float>(s->grey));
  result.polynomial = Polynomial::Zero();
  result.polynomial[0] = median(greys);
  result.noise = deviation_about(chosen, result.polynomial);
  for (int round = 0; round < rounds; ++round) {
    chosen.clear();
    for (const Sample& s : samples) {
      if (std::abs(s.grey - result.polynomial.dot(s.terms)) < 3.0 * result.noise) chosen.push_back(&s);
    }
    result.polynomial = fit(chosen, round < 2 ? 1 : round < 4 ? 3 : 6);
    result.noise = deviation_about(chosen, result.polynomial);
  }
  return result;
}

/// The median of what stands out to one side, and its share of the picture.
struct Side {
  double contrast = 0.0;
  double share = 0.0;
};

Side side_of(const std::vector<Sample>& samples, const Background& background, double sign) {
  std::vector<float> out;
  const double least = std::max(6.0 * background.noise, 0.03);
  for (const Sample& s : samples) {
    const double excess = sign * (s.grey - background.polynomial.dot(s.terms));
    if (excess > least) out.push_back(static_cast<float>(excess));
  }
  if (out.size() < 20) return {};
  const auto share = static_cast<double>(out.size()) / static_cast<double>(samples.size());
  return {median(out), share};
}

}  // namespace

Subject find_subject(const Image& image, const PhotoDeck& deck, Ground ground, const std::string& name) {
  const Background background = fit_background(image, ground);
  const std::vector<Sample> samples = samples_of(image);
  const Side light = side_of(samples, background, 1.0);
  const Side dark = side_of(samples, background, -1.0);
  Subject subject;
  subject.is_light = deck.grains == Grains::light ||
                     (deck.grains == Grains::found && light.contrast * light.share >= dark.contrast * dark.share);
  subject.noise = background.noise;
  subject.contrast = subject.is_light ? light.contrast : dark.contrast;
  const char* const kind = deck.grains == Grains::found ? "" : subject.is_light ? "light " : "dark ";
  if (subject.contrast == 0.0) {
    throw DeckError(fmt::format(
        "{}: no {}grains are found before the background; crop_from and crop_to leave out what is no part of the test, "
        "channel looks at one colour",
        name, kind));
  }
  if (subject.contrast < std::max(deck.least_contrast, 5.0 * subject.noise)) {
    throw DeckError(
        fmt::format("{}: too little contrast: the {}grains differ from the background by {:.3f} of black to white, at "
                    "least {:.3f} is "
                    "needed (the background's noise is {:.3f}); a background of another colour, channel or "
                    "least_contrast would help",
                    name, kind, subject.contrast, std::max(deck.least_contrast, 5.0 * subject.noise), subject.noise));
  }
  const double sign = subject.is_light ? 1.0 : -1.0;
  subject.excess = Image(image.width, image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) {
      const Polynomial terms = terms_at(image, static_cast<double>(x), static_cast<double>(y));
      subject.excess.at(x, y) = static_cast<float>(sign * (image.at(x, y) - background.polynomial.dot(terms)));
    }
  }
  return subject;
}

}  // namespace repose::photo
