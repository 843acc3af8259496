// SPDX-License-Identifier: MIT
// Searches other spheres on a simulation's device. Both keep their answers.
#include "common/scene/contact_scene.h"
#include "common/simulation/simulation.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

class SecondSearch : public KernelTest {};

TEST_P(SecondSearch, StandsBesideTheFirst) {
  if (GetParam() == "cpu") GTEST_SKIP() << "the CPU's searches are functions of the spheres that they are handed";
  std::unique_ptr<Device> opened = open_device(GetParam());
  Device& device = *opened;
  Simulation simulation(std::move(opened));
  const Scene first = make_scene({.name = "uniform", .n = 3000, .packing_fraction = 0.2});
  const Scene second = make_scene({.name = "clustered", .n = 1700, .seed = 5, .radius_ratio = 7});
  const CollideOptions listed{.method = Method::collide_grid, .want_pairs = true};
  simulation.upload(first);
  simulation.collide(listed);

  DeviceContext context(device);
  CellSorter sorter(context);
  PairSearch search(context, sorter);
  context.set_spheres(second);
  context.buffers.resize(SLOT_POSITION, second.size() * sizeof(vec4));
  context.buffers.write(SLOT_POSITION, second.positions);
  sorter.upload(second);
  search.upload(second);
  search.enqueue(listed);
  search.complete();

  EXPECT_EQ(search.pairs(), swept_pairs(second.positions));
  EXPECT_EQ(simulation.pairs(), swept_pairs(first.positions)) << "the answer to the first is still there";
  simulation.move();
  simulation.collide(listed);
  EXPECT_EQ(simulation.pairs(), swept_pairs(simulation.state().positions));
  EXPECT_EQ(search.pairs(), swept_pairs(second.positions)) << "and that to the second";
  context.buffers.check_guards();
  simulation.check_guards();
}
// From rest under gravity steps become longer, so that lists serve fewer and fewer of those that were launched ahead:
// several are then made within one step, each of the spheres as they stand. Kept cells would be those of a list before.
TEST_P(SecondSearch, OfContactsKeepsNoCellsOfSpheresThatMoved) {
  if (GetParam() == "cpu") GTEST_SKIP() << "the others are compared with it";
  Scene scene = make_scene({.name = "gas", .n = 9000, .packing_fraction = 0.05});
  for (size_t i = 0; i < scene.size(); ++i) scene.velocities[i] = {i % 2 ? 0.05f : -0.05f, 0, 0, 0};
  scene.gravity = -9.81f;
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 2e6f});
  backend().upload(scene);
  for (int step = 0; step < 600; ++step) backend().move();
  backend().finish();
  EXPECT_EQ(backend().work_counts().cells_kept, 0u);
  EXPECT_GT(backend().work_counts().sorts + backend().work_counts().orders_kept, 3u) << "lists";
  Backend& cpu = *all_backends().front().backend;
  cpu.upload(scene);
  for (int step = 0; step < 600; ++step) cpu.move();
  EXPECT_EQ(hash_of_state(backend()), hash_of_state(cpu));
  backend().check_guards();
}
INSTANTIATE_BACKENDS(SecondSearch);

}  // namespace
}  // namespace spherepair
