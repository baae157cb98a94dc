#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "files/step_file.h"
#include "measurement/contact_list.h"
#include "measurement/state_hash.h"
#include "output/collect_particles.h"
#include "output/contacts_file.h"
#include "output/snapshot.h"
#include "output/walls_file.h"
#include "run/recorder.h"
#include "run/snapshot_files.h"

namespace repose {

void Recorder::write_snapshot_now(const Simulation& simulation) {
  if (simulation.steps() == last_snapshot_) return;
  last_snapshot_ = simulation.steps();
  const Communicator& comm = simulation.comm();
  SnapshotHeader header;
  header.step = simulation.steps();
  header.time_s = simulation.time();
  header.deck = options_.resolved_deck;
  header.build = options_.build;
  header.state_hash = state_hash(comm, simulation.particles(), simulation.pairs(), simulation.wall_contacts());
  header.inserted = simulation.inserted();
  header.inside = inside(simulation);
  header.left = header.inserted - header.inside;
  for (const MaterialDeck& m : simulation.deck().materials) header.materials.push_back(m.name);
  const std::string name = file_of_step(snapshot_files.prefix, simulation.steps(), snapshot_files.ending);
  const HeatState* heat = simulation.heat() != nullptr ? &simulation.heat()->state() : nullptr;
  write_snapshot(comm, path(name),
                 collect_particles(comm, simulation.materials(), simulation.particles(), simulation.planned(), heat),
                 header);
  if (simulation.deck().output.contacts) write_contacts(simulation);
  if (simulation.deck().output.walls) write_walls(simulation);
  agree_after_root(comm, [&] { snapshots_.add(name, simulation.time()); });
}

void Recorder::write_contacts(const Simulation& simulation) {
  const std::vector<ListedContact> contacts =
      list_contacts(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                    simulation.particles(), simulation.pairs(), simulation.wall_contacts());
  const std::string name = file_of_step(contacts_files.prefix, simulation.steps(), contacts_files.ending);
  agree_after_root(simulation.comm(), [&] { write_text_file(path(name), contacts_text(contacts, simulation.time())); });
}

void Recorder::write_walls(const Simulation& simulation) {
  const std::string name = file_of_step(walls_files.prefix, simulation.steps(), walls_files.ending);
  agree_after_root(simulation.comm(), [&] {
    write_text_file(path(name), walls_text(simulation.walls(), simulation.deck().domain, simulation.time()));
  });
}

}  // namespace repose
