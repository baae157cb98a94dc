#include "import/insertion_sections.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/math.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

constexpr double densest_fill = 0.3;       // share of a region that grains at random places surely find room in
constexpr double most_grains = 1e8;        // of an insertion; a script with more is damaged
constexpr double burst_steps = 100.0;      // between the tries of grains that come at once
constexpr double part_of_clearing = 0.05;  // between the batches of a stream
constexpr double just_above = 1.0 + 1e-6;  // a rate at which a batch is whole in spite of rounding

/// Templates of a distribution that are one material.
struct Portion {
  std::string material = {};
  double density = 0.0;
  double number_share = 0.0;              ///< of all grains
  double mass_share = 0.0;                ///< of their mass
  double mean_mass = 0.0;                 ///< kg
  std::map<double, double> classes = {};  ///< share by diameter, of mass or number as the distribution says
};

double mass_of(const ParticleTemplate& made) { return sphere_volume(made.radius) * made.density; }

std::vector<Portion> portions(const ImportedScene& scene, const ScriptDistribution& distribution,
                              const MaterialsUsed& materials) {
  std::vector<Portion> result;
  double number = 0.0;
  double mass = 0.0;
  for (std::size_t k = 0; k < distribution.templates.size(); ++k) {
    const ParticleTemplate& made = scene.templates.at(distribution.templates[k]);
    const std::string& material = materials.of_grains(made.type, made.density);
    auto portion = std::find_if(result.begin(), result.end(), [&](const Portion& p) { return p.material == material; });
    if (portion == result.end())
      portion = result.insert(result.end(), Portion{.material = material, .density = made.density});
    const double share = distribution.shares[k];
    const double number_share = distribution.is_by_mass ? share / mass_of(made) : share;
    portion->classes[2.0 * made.radius] += share;
    portion->number_share += number_share;
    portion->mass_share += number_share * mass_of(made);
    number += number_share;
    mass += number_share * mass_of(made);
  }
  for (Portion& portion : result) {
    portion.mean_mass = portion.mass_share / portion.number_share;
    portion.number_share /= number;
    portion.mass_share /= mass;
  }
  return result;
}

/// A region as a deck says it.
struct DeckRegion {
  bool is_box = true;
  Extent box = {};
  Vec3 centre = {};
  double radius = 0.0;
  double height = 0.0;

  double volume() const {
    const Vec3 size = box.max - box.min;
    return is_box ? size.x * size.y * size.z : pi * radius * radius * height;
  }
  /// How far a grain moves along a direction until it has surely left.
  double length_along(const Vec3& way) const {
    const Vec3 size = is_box ? box.max - box.min : Vec3{2.0 * radius, 2.0 * radius, height};
    const Vec3 n = (1.0 / norm(way)) * way;
    return std::fabs(n.x) * size.x + std::fabs(n.y) * size.y + std::fabs(n.z) * size.z;
  }
};

DeckRegion deck_region(const ScriptRegion& region, const Extent& domain) {
  if (!region.is_inside) refuse(region.place, "grains come into the inside of a region; this is its outside");
  DeckRegion result;
  if (region.kind == "block") {
    const auto& [min, max] = region.block;
    result.box = {{std::max(min.x, domain.min.x), std::max(min.y, domain.min.y), std::max(min.z, domain.min.z)},
                  {std::min(max.x, domain.max.x), std::min(max.y, domain.max.y), std::min(max.z, domain.max.z)}};
    return result;
  }
  if (region.kind != "cylinder")
    refuse(region.place, fmt::format("grains in a {}: block and cylinder are known", region.kind));
  if (region.axis != 'z')
    refuse(region.place, "grains in a cylinder that is not upright; only one along z has a counterpart");
  const double low = std::max(region.low, domain.min.z);
  result.is_box = false;
  result.centre = {region.c1, region.c2, low};
  result.radius = region.radius;
  result.height = std::min(region.high, domain.max.z) - low;
  return result;
}

class InsertionWriter {
 public:
  InsertionWriter(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const WallNames& walls,
                  const Extent& domain)
      : deck_(deck), scene_(scene), materials_(materials), walls_(walls), domain_(domain) {}

  void write(const ScriptInsertion& insertion) {
    now_ = &insertion;
    first_step_ = 0;
    last_step_ = 0;
    for (std::size_t run = 0; run < scene_.runs.size(); ++run) {
      if (run < insertion.from) first_step_ += scene_.runs[run].steps;
      if (run < insertion.until) last_step_ += scene_.runs[run].steps;
    }
    first_step_ = std::max(first_step_, insertion.start);
    if (first_step_ >= last_step_) {
      scene_.needless.push_back({insertion.place, "fix " + insertion.name, "it ends before it begins"});
      return;
    }
    portions_ = portions(scene_, scene_.distributions.at(insertion.distribution), materials_);
    if (insertion.kind == InsertionKind::pack) {
      pack(deck_region(scene_.regions.at(insertion.region), domain_));
    } else {
      stream();
    }
  }

 private:
  double step() const { return *scene_.timestep; }
  double start_time() const { return static_cast<double>(first_step_) * step(); }

  void begin(const Portion& portion, const std::string& type) {
    deck_.section("[[particles]]", now_->place);
    deck_.key("type", type);
    deck_.key("material", portion.material);
    if (portion.classes.size() == 1 && type == "pour") deck_.key("diameter", portion.classes.begin()->first);
  }

  void region(const DeckRegion& region) {
    deck_.key("region", region.is_box ? "box" : "cylinder");
    if (region.is_box) {
      deck_.key("min", region.box.min);
      deck_.key("max", region.box.max);
    } else {
      deck_.key("centre", region.centre);
      deck_.key("radius", region.radius);
      deck_.key("height", region.height);
    }
  }

  /// A fill takes single diameters too as a distribution, which is spread at random.
  void end(const Portion& portion, bool is_fill) {
    if (!(now_->velocity == Vec3{})) deck_.key("velocity", now_->velocity);
    if (portion.classes.size() == 1 && !is_fill) return;
    std::vector<double> diameters;
    std::vector<double> shares;
    for (const auto& [diameter, share] : portion.classes) {
      diameters.push_back(diameter);
      shares.push_back(share);
    }
    const ScriptDistribution& distribution = scene_.distributions.at(now_->distribution);
    deck_.section("[particles.sizes]", distribution.place);
    deck_.key("type", "classes");
    deck_.key("by", distribution.is_by_mass ? "mass" : "number");
    deck_.key("diameters", diameters);
    deck_.key("shares", shares);
  }

  /// How many grains of a portion a region is to hold.
  double wanted(const Portion& portion, const DeckRegion& region) const {
    if (now_->region_count) return *now_->region_count * portion.number_share;
    const double density_of_all = [&] {
      double inverse = 0.0;
      for (const Portion& p : portions_) inverse += p.mass_share / p.density;
      return 1.0 / inverse;
    }();
    const double mass =
        now_->region_mass ? *now_->region_mass : *now_->volume_fraction * region.volume() * density_of_all;
    return mass * portion.mass_share / portion.mean_mass;
  }

  double filled_share(const DeckRegion& region) const {
    double volume = 0.0;
    for (const Portion& portion : portions_) volume += wanted(portion, region) * portion.mean_mass / portion.density;
    return volume / region.volume();
  }

  std::int64_t whole(double count) const {
    if (!(count <= most_grains)) refuse(now_->place, fmt::format("{:.3g} grains in one insertion", count));
    return std::max<std::int64_t>(1, std::llround(count));
  }

  void note(const std::string& reason) {
    scene_.missing.push_back({now_->place, "fix " + now_->name + " insert/pack", reason});
  }

  /// Whether grains have left the region before more come.
  bool is_emptied(const DeckRegion& region, double interval) const {
    const Vec3 way = norm(now_->velocity) > 0.0 ? now_->velocity : scene_.gravity;
    if (!(norm(way) > 0.0)) return false;
    const double pull = std::max(0.0, dot(scene_.gravity, way) / norm(way));
    return norm(now_->velocity) * interval + 0.5 * pull * interval * interval >= region.length_along(way);
  }

  void pack(const DeckRegion& where) {
    const double interval = static_cast<double>(std::max<std::int64_t>(0, now_->every)) * step();
    const bool repeats = now_->every > 0 && first_step_ + 1 + now_->every <= last_step_;
    const bool is_emptied_before = repeats && is_emptied(where, interval);
    const bool fits = filled_share(where) <= densest_fill;
    const bool begins_filled = first_step_ == 0 && portions_.size() == 1 && fits;
    const std::int64_t times = is_emptied_before ? (last_step_ - first_step_ - 1) / now_->every + 1 : 1;
    for (const Portion& portion : portions_) {
      const std::int64_t count = whole(wanted(portion, where));
      if (begins_filled) fill(portion, where, count);
      if (begins_filled && times == 1) continue;
      const std::int64_t rest =
          whole(static_cast<double>(count) * static_cast<double>(begins_filled ? times - 1 : times));
      const bool tries_again = repeats && !is_emptied_before;
      const double every = is_emptied_before || tries_again ? interval : burst_steps * step();
      batches(portion, where, rest, static_cast<double>(count) / every * (is_emptied_before ? just_above : 2.0), every);
    }
    if (repeats && !is_emptied_before) {
      note(fmt::format("each {} steps LIGGGHTS fills the region up again; here its grains come once, as they find room",
                       now_->every));
    }
  }

  void fill(const Portion& portion, const DeckRegion& where, std::int64_t count) {
    begin(portion, "fill");
    deck_.key("count", count);
    region(where);
    end(portion, true);
  }

  void batches(const Portion& portion, const DeckRegion& where, std::int64_t count, double rate, double every) {
    begin(portion, "pour");
    deck_.key("count", count);
    deck_.key("particle_rate", rate);
    if (first_step_ > 0) deck_.key("start_time", start_time());
    deck_.key("interval", every);
    region(where);
    end(portion, false);
  }

  /// All that is to come, cut off by an unfix before the script ends.
  double amount(std::optional<double> wanted, double rate) const {
    const double duration = static_cast<double>(last_step_ - first_step_) * step();
    if (!wanted) return rate * duration;
    return now_->until < scene_.runs.size() ? std::min(*wanted, rate * duration) : *wanted;
  }

  /// A small part of the time in which the largest grain moves by its diameter: grains enter as soon as there is room,
  /// which lets through about as many as LIGGGHTS finds places for in the volume behind the face.
  double stream_interval() const {
    double largest = 0.0;
    for (const Portion& portion : portions_) largest = std::max(largest, portion.classes.rbegin()->first);
    const double steps = std::floor(part_of_clearing * largest / norm(now_->velocity) / step());
    return std::max(1.0, steps) * step();
  }

  /// By numbers, as LIGGGHTS does it: masses are divided by the mean mass of a grain.
  void stream() {
    double mean_mass = 0.0;
    for (const Portion& portion : portions_) mean_mass += portion.number_share * portion.mean_mass;
    const double rate = now_->mass_rate ? *now_->mass_rate / mean_mass : *now_->particle_rate;
    std::optional<double> wanted = now_->count;
    if (!wanted && now_->mass) wanted = std::floor(*now_->mass / mean_mass);
    const double count = amount(wanted, rate);
    for (const Portion& portion : portions_) {
      begin(portion, "pour");
      deck_.key("count", whole(count * portion.number_share));
      deck_.key("particle_rate", rate * portion.number_share);
      if (first_step_ > 0) deck_.key("start_time", start_time());
      if (now_->kind == InsertionKind::stream) {
        deck_.key("region", "face");
        deck_.key("face", walls_.faces.at(now_->face));
        if (norm(now_->velocity) > 0.0) deck_.key("interval", stream_interval());
      } else {
        if (now_->every > 0) deck_.key("interval", static_cast<double>(now_->every) * step());
        region(deck_region(scene_.regions.at(now_->region), domain_));
      }
      end(portion, false);
    }
  }

  DeckText& deck_;
  ImportedScene& scene_;
  const MaterialsUsed& materials_;
  const WallNames& walls_;
  const Extent& domain_;
  const ScriptInsertion* now_ = nullptr;
  std::int64_t first_step_ = 0;  ///< behind which the first grains come
  std::int64_t last_step_ = 0;
  std::vector<Portion> portions_;
};

}  // namespace

void write_insertions(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const WallNames& walls,
                      const Extent& domain) {
  InsertionWriter writer(deck, scene, materials, walls, domain);
  for (const ScriptInsertion& insertion : scene.insertions) writer.write(insertion);
}

}  // namespace repose
