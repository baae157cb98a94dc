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
constexpr int rounds = 24;
constexpr double within = 2.5;                  // standard deviations, of what belongs to the background
constexpr double cut_off = 1.05;                // by which that makes the standard deviation too small
constexpr double deviation_of_median = 1.4826;  // standard deviation over the median of absolute deviations

struct Sample {
  double column = 0.0;
  double row = 0.0;
  Polynomial terms;
  double grey = 0.0;
};

/// The terms of the polynomial at a pixel, with x and y from -1 to 1.
Polynomial terms_at(const Image& image, double column, double row) {
  const double x = 2.0 * column / static_cast<double>(image.width) - 1.0;
  const double y = 2.0 * row / static_cast<double>(image.height) - 1.0;
  return {1.0, x, y, x * x, x * y, y * y};
}

bool is_above(const Image& image, const Sample& s) {
  const auto w = static_cast<double>(image.width);
  const auto h = static_cast<double>(image.height);
  return s.row < 0.08 * h || (s.row < 0.4 * h && (s.column < 0.08 * w || s.column > 0.92 * w));
}

std::vector<Sample> samples_of(const Image& image) {
  const auto pixels = static_cast<double>(image.width) * static_cast<double>(image.height);
  const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(pixels / most_samples)));
  std::vector<Sample> samples;
  for (std::size_t y = step / 2; y < image.height; y += step) {
    for (std::size_t x = step / 2; x < image.width; x += step) {
      const auto column = static_cast<double>(x);
      const auto row = static_cast<double>(y);
      samples.push_back({column, row, terms_at(image, column, row), image.at(x, y)});
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

double off(const Sample& sample, const Polynomial& polynomial) {
  return std::abs(sample.grey - polynomial.dot(sample.terms));
}

/// The middle of the half of the grey values that lie closest together.
double level_of(const std::vector<const Sample*>& samples) {
  std::vector<double> greys;
  for (const Sample* s : samples) greys.push_back(s->grey);
  std::sort(greys.begin(), greys.end());
  const std::size_t half = greys.size() / 2;
  std::size_t first = 0;
  for (std::size_t i = 0; i + half < greys.size(); ++i) {
    if (greys[i + half] - greys[i] < greys[first + half] - greys[first]) first = i;
  }
  return 0.5 * (greys[first] + greys[first + half]);
}

/// Least trimmed squares (Rousseeuw and Van Driessen 2006, doi:10.1007/s10618-005-0024-4): fitted again and again to
/// the half that is nearest to the last fit, a slope first, then a curvature.
Polynomial trimmed_fit(std::vector<const Sample*> samples) {
  Polynomial polynomial = Polynomial::Zero();
  polynomial[0] = level_of(samples);
  const auto half = static_cast<std::ptrdiff_t>(samples.size() / 2);
  for (int round = 0; round < rounds; ++round) {
    std::nth_element(samples.begin(), samples.begin() + half, samples.end(),
                     [&](const Sample* a, const Sample* b) { return off(*a, polynomial) < off(*b, polynomial); });
    polynomial = fit({samples.begin(), samples.begin() + half + 1}, round < rounds / 4 ? 3 : 6);
  }
  return polynomial;
}

/// Fits what is known to be background, or the half of all that agrees best, and then all that agrees with it.
Background fit_background(const Image& image, const std::vector<Sample>& samples, Ground ground) {
  std::vector<const Sample*> chosen;
  for (const Sample& s : samples) {
    if (ground == Ground::around || is_above(image, s)) chosen.push_back(&s);
  }
  Background result{.polynomial = trimmed_fit(chosen)};
  std::vector<float> distances;
  for (const Sample* s : chosen) distances.push_back(static_cast<float>(off(*s, result.polynomial)));
  result.noise = std::max(least_noise, deviation_of_median * static_cast<double>(median(distances)));
  for (int round = 0; round < 5; ++round) {
    chosen.clear();
    double squares = 0.0;
    for (const Sample& s : samples) {
      const double distance = off(s, result.polynomial);
      if (distance > within * result.noise) continue;
      chosen.push_back(&s);
      squares += distance * distance;
    }
    result.polynomial = fit(chosen, 6);
    result.noise = std::max(least_noise, cut_off * std::sqrt(squares / static_cast<double>(chosen.size())));
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
  const std::vector<Sample> samples = samples_of(image);
  const Background background = fit_background(image, samples, ground);
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
