#include "simulation/contact_alarm.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "contact/pair_loop.h"

namespace repose {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Two bodies that touch, in words, and the smaller particle of them.
struct Touching {
  double share = -std::numeric_limits<double>::infinity();  ///< overlap over its radius
  std::size_t particle = 0;
  std::string bodies;
  std::string wall;  ///< empty: a pair
};

Touching touching(const Particles& particles, std::int32_t first, std::int32_t second) {
  const ParticleRecord& a = particles.record[at(first)];
  const ParticleRecord& b = particles.record[at(second)];
  const double overlap = a.radius + b.radius - norm(a.position - b.position);
  return {overlap / std::min(a.radius, b.radius),
          at(b.radius < a.radius ? second : first),
          fmt::format("particles {} and {}", particles.id[at(first)], particles.id[at(second)]),
          {}};
}

Touching touching(const Particles& particles, const WallContact& contact, std::span<const Wall> walls) {
  const auto i = at(contact.particle);
  const std::string& wall = walls[at(contact.wall)].name;
  return {contact.overlap / particles.record[i].radius, i,
          fmt::format("particle {} and wall {}", particles.id[i], wall), wall};
}

/// The pairs of the inner lists.
template <class Visit>
void for_each_pair(const PairLists& pairs, const Visit& visit) {
  for (const PairGroup& group : pairs.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) {
      if (pair.lane >= 0) visit(group, pair);
    }
  }
}

Touching deepest(const GuardView& view, const ContactView& contacts) {
  const Particles& particles = view.particles;
  Touching worst;
  const auto consider = [&](Touching&& found) {
    if (found.share > worst.share) worst = std::move(found);
  };
  for_each_pair(contacts.pairs, [&](const PairGroup&, const PairGroup::Pair& pair) {
    const double reach = particles.record[at(pair.first)].radius + particles.record[at(pair.second)].radius;
    const Vec3 apart = particles.record[at(pair.first)].position - particles.record[at(pair.second)].position;
    if (norm(apart) < reach) consider(touching(particles, pair.first, pair.second));
  });
  for (const WallContact& c : contacts.wall_contacts.contacts(contacts.walls, particles)) {
    consider(touching(particles, c, contacts.walls));
  }
  return worst;
}

/// Evaluates contacts one by one, without advancing their histories, to see whose forces are out of range.
class RangeSearch {
 public:
  RangeSearch(const GuardView& view, const ContactView& contacts)
      : view_(view), contacts_(contacts), sums_(view.particles.record.size(), ForceSum{}) {}

  std::optional<Touching> find() {
    std::optional<Touching> found;
    for_each_pair(contacts_.pairs, [&](const PairGroup& group, const PairGroup::Pair& pair) {
      if (!found && is_out_of_range(group, pair)) found = touching(view_.particles, pair.first, pair.second);
    });
    std::vector<WallContact> at_walls = contacts_.wall_contacts.contacts(contacts_.walls, view_.particles);
    for (WallContact& contact : at_walls) {
      if (!found && is_out_of_range(contact)) found = touching(view_.particles, contact, contacts_.walls);
    }
    return found;
  }

 private:
  bool is_out_of_range(const PairGroup& group, const PairGroup::Pair& pair) {
    const auto dummy = static_cast<std::int32_t>(view_.particles.total());  // two, far apart, behind the ghosts
    ContactBlock block = {};
    std::fill(std::begin(block.first), std::end(block.first), dummy);
    std::fill(std::begin(block.second), std::end(block.second), dummy + 1);
    block.first[0] = pair.first;
    block.second[0] = pair.second;
    set_history(block, 0, lane_history(group, at(pair.lane)));
    const PairParameters& law = view_.materials.pair(at(group.material_first), at(group.material_second));
    return evaluate_pairs(contacts_.level, {&block, 1}, law, 0.0, contacts_.max_overlap, view_.particles.record.data(),
                          sums_.data())
               .out_of_range > 0;
  }
  bool is_out_of_range(WallContact& contact) {
    const Wall& wall = contacts_.walls[at(contact.wall)];
    const std::int32_t material = view_.particles.material[at(contact.particle)];
    constexpr std::array<std::int32_t, 1> only = {0};
    return evaluate_walls(contacts_.level, wall_law(view_.materials, material, wall, 0.0, contacts_.max_overlap),
                          {&contact, 1}, only, view_.particles.record.data(), sums_.data())
               .out_of_range > 0;
  }

  const GuardView& view_;
  const ContactView& contacts_;
  BigVector<ForceSum> sums_;
};

std::optional<std::size_t> with_too_many_touches(const Particles& particles, const ContactView& contacts) {
  const std::span<const Wall> walls = contacts.walls;
  TouchBuffer touches;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) continue;
    touches.clear();
    for (std::size_t w = 0; w < walls.size(); ++w) {
      if (!walls[w].present) continue;
      const double reach = particles.record[i].radius + contacts.wall_contacts.adhesion_range();
      find_touches(walls[w], static_cast<int>(w), particles.position(i), reach, touches);
    }
    if (touches.overflowed()) return i;
  }
  return {};
}

Alarm too_deep(const GuardView& view, const Touching& t, double bound) {
  const std::string bodies = t.wall.empty()
                                 ? fmt::format("{} overlap by {:.2f} of the smaller radius", t.bodies, t.share)
                                 : fmt::format(
                                       "particle {} is pressed through wall {}: they overlap by "
                                       "{:.2f} of its radius",
                                       view.particles.id[t.particle], t.wall, t.share);
  return alarm_at(view, t.particle, view.particles.record[t.particle].position,
                  fmt::format("{} at {}, more than guards.max_overlap = {:.2f}; shorten time.step, raise "
                              "youngs_modulus, or look for grains that start inside one another",
                              bodies, place_text(view.particles.position(t.particle)), bound));
}

Alarm out_of_range(const GuardView& view, const Touching& t) {
  const ParticleRecord& p = view.particles.record[t.particle];
  return alarm_at(
      view, t.particle, p.position,
      fmt::format("the contact force of {} at {} is beyond the range of the fixed-point sums: particle {} "
                  "moves at {:.3g} m/s, with an overlap of {:.2g} of its radius; shorten time.step, or look "
                  "for what has driven it",
                  t.bodies, place_text(view.particles.position(t.particle)), view.particles.id[t.particle],
                  norm(p.velocity), t.share));
}

}  // namespace

Alarm contact_alarm(const GuardView& view, const ContactView& contacts) {
  const Touching worst = deepest(view, contacts);
  if (worst.share > contacts.max_overlap) return too_deep(view, worst, contacts.max_overlap);
  if (const auto found = RangeSearch(view, contacts).find()) return out_of_range(view, *found);
  if (const auto i = with_too_many_touches(view.particles, contacts)) {
    return alarm_at(view, *i, view.particles.record[*i].position,
                    fmt::format("particle {} at {} touches walls in more than {} places; simplify the walls there",
                                view.particles.id[*i], place_text(view.particles.position(*i)), TouchBuffer::capacity));
  }
  return alarm_at(view, worst.particle, view.particles.record[worst.particle].position,
                  "a contact force is beyond the range of the fixed-point sums; shorten time.step, or look for "
                  "particles that are driven too fast");
}

}  // namespace repose
