#include "import/insertion_sections.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "import/insertion_portion.h"
#include "import/insertion_region.h"

namespace repose {
namespace {

constexpr double densest_fill = 0.3;       // share of a region that grains at random places surely find room in
constexpr double most_grains = 1e8;        // of an insertion; a script with more is damaged
constexpr double burst_steps = 100.0;      // between the tries of grains that come at once
constexpr double part_of_clearing = 0.05;  // between the batches of a stream
constexpr double just_above = 1.0 + 1e-6;  // a rate at which a batch is whole in spite of rounding
constexpr double small_radius = 0.05;      // of a region: which grains lie wholly in it or not is no matter then

/// What an insertion into a region has brought.
struct Inserted {
  const ScriptInsertion* by;
  DeckRegion region;
  DeckRegion grown;  ///< in which its grains lie
  std::int64_t step;
  Amount amount;
};

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
  /// Between batches, of which the first comes that much after the start: in time before the script ends.
  double batch_steps(double wanted) const {
    return std::min(wanted, std::max(1.0, std::floor(0.5 * static_cast<double>(scene_.steps() - first_step_))));
  }
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

  std::int64_t whole(double count) const {
    if (!(count <= most_grains)) refuse(now_->place, fmt::format("{:.3g} grains in one insertion", count));
    return std::max<std::int64_t>(1, std::llround(count));
  }

  void note(const std::string& reason) {
    const std::string style = now_->kind == InsertionKind::pack ? "insert/pack" : "insert/rate/region";
    scene_.missing.push_back({now_->place, "fix " + now_->name + " " + style, reason});
  }

  bool is_there(const ScriptWall& wall) const { return wall.from < now_->until && now_->from < wall.until; }

  /// Whether grains have left the region before more come.
  bool is_emptied(const DeckRegion& region, double interval) const {
    const Vec3 way = norm(now_->velocity) > 0.0 ? now_->velocity : scene_.gravity;
    if (!(norm(way) > 0.0)) return false;
    const bool stays = std::any_of(scene_.walls.begin(), scene_.walls.end(), [&](const ScriptWall& wall) {
      return is_there(wall) && is_held(region, way, largest_diameter(portions_), wall);
    });
    const double pull = std::max(0.0, dot(scene_.gravity, way) / norm(way));
    return !stays && norm(now_->velocity) * interval + 0.5 * pull * interval * interval >= region.length_along(way);
  }

  /// With `all_in no` only centres have to lie in the region.
  DeckRegion region_of_grains(const DeckRegion& centres) {
    if (now_->all_in) return centres;
    const double radius = 0.5 * largest_diameter(portions_);
    std::vector<const ScriptWall*> walls;
    for (const ScriptWall& wall : scene_.walls) {
      if (is_there(wall)) walls.push_back(&wall);
    }
    const bool is_known =
        std::all_of(walls.begin(), walls.end(), [&](const ScriptWall* wall) { return can_bound(centres, *wall); });
    if (is_known) return grown(centres, radius, domain_, walls);
    if (radius > small_radius * centres.smallest_size())
      note("without all_in yes LIGGGHTS places centres up to the bounds of the region; here whole grains are in it");
    return centres;
  }

  /// What LIGGGHTS finds in the region: grains of lists, and of packs of the same region at the same step.
  Amount grains_in(const DeckRegion& region) const {
    Amount there = first_step_ > 0 ? Amount{} : amount_of_list(scene_, scene_.regions.at(now_->region));
    for (const Inserted& earlier : inserted_) {
      if (!is_part_of(earlier, region)) continue;
      const Amount& more = earlier.amount;
      there = {there.count + more.count, there.mass + more.mass, there.volume + more.volume};
    }
    return there;
  }

  bool is_part_of(const Inserted& earlier, const DeckRegion& region) const {
    return earlier.step == first_step_ && are_same(earlier.region, region);
  }

  /// Of grains that may be in the region by then, in a number that only the simulation knows.
  void note_earlier(const DeckRegion& region, double count) {
    for (const Inserted& earlier : inserted_) {
      if (is_part_of(earlier, region) || !overlap(earlier.region, region)) continue;
      note(
          fmt::format("LIGGGHTS counts the grains of fix {} that are in its region by then, and adds what is lacking; "
                      "here all {} come",
                      earlier.by->name, whole(count)));
    }
  }

  void pack(const DeckRegion& region) {
    const DeckRegion where = region_of_grains(region);
    const Amount there = grains_in(region);
    const Amount more = lacking(*now_, portions_, region.volume(), there);
    const bool is_shared =
        there.count > 0.0 || std::any_of(inserted_.begin(), inserted_.end(),
                                         [&](const auto& earlier) { return overlap(earlier.grown, where); });
    note_earlier(region, more.count);
    if (now_->region_count ? more.count < 0.5 : !(more.count > 0.0)) {
      scene_.needless.push_back({now_->place, "fix " + now_->name, "its region has as many grains before"});
      return;
    }
    write_pack(region, where, there, is_shared);
    inserted_.push_back({now_, region, where, first_step_, more});
  }

  void write_pack(const DeckRegion& region, const DeckRegion& where, const Amount& there, bool is_shared) {
    const double interval = static_cast<double>(std::max<std::int64_t>(0, now_->every)) * step();
    const bool repeats = now_->every > 0 && first_step_ + 1 + now_->every <= last_step_;
    const bool is_emptied_before = repeats && is_emptied(region, interval);
    const double filled = (there.volume + lacking(*now_, portions_, region.volume(), there).volume) / where.volume();
    const bool begins_filled = first_step_ == 0 && portions_.size() == 1 && filled <= densest_fill && !is_shared;
    const std::int64_t times = is_emptied_before ? (last_step_ - first_step_ - 1) / now_->every + 1 : 1;
    std::int64_t all = 0;
    for (const Portion& portion : portions_) {
      const std::int64_t count = whole(lacking(*now_, portions_, portion, region.volume(), there));
      const std::int64_t each = whole(lacking(*now_, portions_, portion, region.volume(), {}));
      const std::int64_t later = times > 1 ? whole(static_cast<double>(each) * static_cast<double>(times - 1)) : 0;
      all += whole(static_cast<double>(count + later));
      if (begins_filled) fill(portion, where, count);
      if (begins_filled && later == 0) continue;
      const double every = repeats ? interval : batch_steps(burst_steps) * step();
      const double rate = static_cast<double>(each) / every * (is_emptied_before ? just_above : 2.0);
      batches(portion, where, begins_filled ? later : count + later, rate, every);
    }
    note_amount(all, repeats, is_emptied_before, filled);
  }

  /// LIGGGHTS fills a region as far as it finds places; a deck has a number of grains.
  void note_amount(std::int64_t all, bool repeats, bool is_emptied_before, double filled) {
    if (repeats) {
      note(fmt::format("each {} steps LIGGGHTS fills the region up again; here {}", now_->every,
                       is_emptied_before ? fmt::format("it is taken as empty by then, and {} grains come in all", all)
                                         : fmt::format("its {} grains come once, as they find room", all)));
    } else if (filled > densest_fill) {
      note(
          fmt::format("the region would be {:.0f} % full: LIGGGHTS inserts as many grains as find a place; here all {} "
                      "come, as they find room",
                      100.0 * filled, all));
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
    const double steps = std::floor(part_of_clearing * largest_diameter(portions_) / norm(now_->velocity) / step());
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
    DeckRegion where;
    if (now_->kind == InsertionKind::rate_region) {
      const DeckRegion centres = deck_region(scene_.regions.at(now_->region), domain_);
      where = region_of_grains(centres);
      inserted_.push_back({now_, centres, where, first_step_, {}});
    }
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
        if (now_->every > 0) deck_.key("interval", batch_steps(static_cast<double>(now_->every)) * step());
        region(where);
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
  std::vector<Inserted> inserted_;
};

}  // namespace

void write_insertions(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const WallNames& walls,
                      const Extent& domain) {
  InsertionWriter writer(deck, scene, materials, walls, domain);
  for (const ScriptInsertion& insertion : scene.insertions) writer.write(insertion);
}

}  // namespace repose
