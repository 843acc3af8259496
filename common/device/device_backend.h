// SPDX-License-Identifier: MIT
// The host side that GLSL and CUDA have in common: which kernels run in which order, on which grid, with which
// parameters, and what happens when a list is too short. The two APIs only allocate, copy and launch.
#pragma once

#include <optional>
#include <set>
#include <utility>

#include "common/backend/backend.h"
#include "common/backend/plan_watch.h"
#include "common/device/kernel_list.h"
#include "common/device/variant.h"
#include "common/scene/scene_params.h"

namespace spherepair {

#define ENUMERATOR(name) name,
enum class Kernel { SPHEREPAIR_KERNELS(ENUMERATOR) };
#undef ENUMERATOR

// `groups` along one axis, folded into the next where one dispatch cannot hold them.
std::array<uint, 3> folded(uint64_t groups);

const char* kernel_name(Kernel kernel);  // the stem of its two source files
bool takes_view(Kernel kernel);          // those that draw

// Which copy of the spheres a kernel sees as positions and counts.
enum class Order { scene, buckets, cells };
inline uint position_slot(Order order) {
  return order == Order::cells ? SLOT_SORTED : order == Order::buckets ? SLOT_SPLIT : SLOT_POSITION;
}
inline uint id_slot(Order order) { return order == Order::buckets ? SLOT_SPLIT_ID : SLOT_ID; }
inline uint count_slot(Order order) { return order == Order::cells ? SLOT_SORTED_COUNT : SLOT_COUNT; }

struct Launch {
  Kernel kernel;
  uint block;  // threads per group
  Variant variant;
  std::array<uint, 3> groups;
  Order order = Order::scene;   // that a kernel sees as positions, counts (count_slot) and sphere numbers
  Order target = Order::cells;  // that it writes
  uint table = SLOT_CELL;       // of the scan
  const char* stage = nullptr;  // what its time is that of, where not of the kernel's name
  std::optional<Kernel> overlaps_previous = {};  // where that was launched last, it may be under way still: nothing
                                                 // that either of the two writes is used by the other
};

inline uint count_slot(const Launch& launch) {  // those that draw see contacts by the number of the sphere
  return takes_view(launch.kernel) ? SLOT_COUNT : count_slot(launch.order);
}
inline const char* stage_name(const Launch& launch) { return launch.stage ? launch.stage : kernel_name(launch.kernel); }

class DeviceBackend : public Backend {
 public:
  std::vector<Method> methods() const override { return device_methods(); }
  void upload(const Scene& scene) override;
  void move() override;
  void set_event_driven(bool on) override { event_driven_ = on; }
  void evaluate_positions() override;
  void collide(const CollideOptions& options) override;
  MethodChoice choice(const CollideOptions& options) const override;
  Collisions collisions() override;
  std::vector<uint> counts() override;
  std::vector<Pair> pairs() override;
  State state() override;
  MotionState save() override;
  void resume(const Scene& scene, const MotionState& saved) override;
  void draw(const View& view, const DrawOptions& options) override;
  std::vector<uint> image() override;
  std::vector<uvec2> visible() override;
  DrawStatistics draw_statistics() override;
  std::vector<uint> decide(std::span<const vec4> spheres) override;
  void launch_empty(uint groups) override;
  void launch_peak_rate(PeakRate ceiling) override;
  void check_peak_rate(PeakRate ceiling) override;
  void check_guards() override;
  WorkCounts work_counts() const override { return work_; }

 protected:
  // A buffer of so many bytes at a slot, in place of what was there. Throws BackendError with the bytes asked and free.
  virtual void allocate(uint slot, uint64_t bytes) = 0;
  virtual void write(uint slot, const void* data, uint64_t offset, uint64_t bytes) = 0;
  virtual void read(uint slot, void* data, uint64_t offset, uint64_t bytes) = 0;  // waits for the device
  virtual void launch(const Launch& launch, const Params& params) = 0;
  virtual uint64_t largest_binding() const = 0;  // bytes that a kernel can reach in one buffer
  virtual std::vector<Pair> read_pairs(uint64_t count);
  virtual bool has_atomics_64() const = 0;

  // What one API alone offers (ApiOptions, Sort::radix, Scan::library); check_api_options throws std::invalid_argument
  // that names what this one lacks.
  virtual void check_api_options(const CollideOptions& options) const = 0;
  // Whether this kernel, collide_grid, draw_cull or one that sorts by buckets, reads the table of cells, the pyramid or
  // the spheres through texture buffers. Throws when that is asked for and they do not fit.
  virtual bool takes_texture(Kernel, const ApiOptions&) const { return false; }
  virtual uint bounds_block() const { return SERVICE_BLOCK; }  // group size of grid_bounds
  virtual void begin_step(const ApiOptions&) {}                // around the launches of a collision step
  virtual void end_step() {}
  virtual void clear_buffer(uint slot, uint64_t bytes) = 0;  // to 0, by the API's own function
  virtual void library_scan() {}  // of SLOT_CELL: counts one slot ahead of their cells become starts
  virtual void library_sort() {}  // SLOT_POSITION into cell order: SLOT_CELL, SLOT_SORTED, SLOT_ID; counts 0
  const Params& params() const { return params_; }  // of the step that is being launched
  WorkCounts work_;                                 // launches are counted by the API

  // The methods of draw_methods() but for compute; contacts stand in SLOT_COUNT, by the number of the sphere.
  virtual void draw_by_pipeline(DrawMethod) {}
  virtual std::vector<uint> pipeline_image() { return {}; }
  // Positions of this step, and contacts in SLOT_COUNT by the number of the sphere: 0 where none were found since a
  // move. Those that are `sorted` stay where they are: draw_spheres and draw_clusters bring along what is seen.
  void ready_to_draw(bool sorted = false);
  const View& view() const { return view_; }  // of the draw_* kernels
  uint64_t pyramid_texels() const;            // of its pyramid
  uint visible_slot() const { return visible_slot_; }
  virtual bool graph_pays() const { return false; }         // more than steps that overlap, see ApiOptions
  virtual bool overlaps_launches() const { return false; }  // pictures do, see Launch::beside
  uint spheres() const { return uint(n_); }

 private:
  void require_scene(const char* what) const;
  void make_buffer(uint slot, uint64_t bytes);
  uint64_t fitting(uint64_t bytes) const;
  void write_state(const MotionState& state);
  void launch_motion(Kernel kernel, bool whole_state);
  void evaluate_all(bool whole_state);
  void prepare_positions();
  void run_collide();
  bool grow_lists(uint64_t deferred, uint64_t listed);
  std::vector<uint> read_summary(), finished_summary();
  struct Division {
    Kernel kernel;
    uint64_t spheres, meets;  // of one group
  };
  Division division() const;
  void launch_collide();
  void resolve_undecided();
  std::pair<Method, bool> search() const { return {options_.method, search_decides_}; }
  void launch_clear(Order order);
  void launch_bounds();
  void launch_grid();
  void sort_into_cells();
  bool stands_in_cell_order();
  void plan_cells();
  uint indices_of(Order order) const {  // as Params::in_cells
    return order != Order::cells ? 0 : index_in_w_ ? INDEX_IN_W : INDEX_IN_ID;
  }
  std::vector<uint> numbers_in_cell_order();
  // As Launch::beside, of what uses nothing of a search in cell order.
  std::optional<Kernel> overlaps_search() const {
    return options_.api.overlaps(graph_pays()) ? std::optional(Kernel::collide_grid) : std::nullopt;
  }
  Variant sorter(Kernel kernel) const;
  void split(uint shift, uint parent_shift, uint first_bucket, Order from, Order to);
  void split_tiles(uint shift, uint buckets);
  void split_twice(uint shift, uint buckets, uint parent_shift);
  void launch_scan(uint table);
  void sort_by_counting();
  void sort_by_buckets();
  void sort_by_library();
  void clear_for_sort(uint64_t bucket_words);
  std::vector<vec4> sample_positions();
  bool replan_if_needed(const CollideOptions& asked);
  void launch_sorter(Kernel kernel, uint block, uint64_t groups);

  void build_cells();

  void make_draw_buffers();
  void make_visible_buffer();
  void choose_visible_slot(bool alone);
  void require_drawn(bool by_compute) const;
  void launch_draw();
  void launch_rasteriser(bool keep = false);
  uint64_t drawn_results() const { return pixels_kept_ ? 0 : DRAWN_WORDS * sizeof(uint); }  // in SLOT_DRAWN
  bool grow_draw_lists();
  bool same_image(const View& view, const DrawOptions& options) const;
  void draw_all(const Params& params, Order order);
  void draw_clusters(const Params& params, Order order);
  void draw_phase(uint phase, const Params& params, Order order);
  void cull(uint phase, const Params& params);
  bool eye_among_cells() const;
  bool may_be_large() const;
  void draw_tiles(const Params& params);
  void restart_lists();
  void make_clusters(const Params& params, Order order);
  void make_seen_list();
  void launch_per_pixel(Kernel kernel, const Params& params);
  void finish_draw();

  std::array<uint, 3> per_sphere_groups() const;

  uint64_t n_ = 0;
  Variant variant_;  // for this scene and step
  MotionOptions motion_;
  std::string unmovable_;  // why
  uint steps_ = 0;         // of anchored
  bool evaluated_ = true;  // positions are those of this step
  bool event_driven_ = true;
  std::array<Params, 2> constants_{};  // of the scene: [exact]
  GridPlans plans_;
  PlanWatch watch_;                                // whether they still fit
  uint64_t moves_to_wait_ = 0, moves_waited_ = 0;  // before the cell order is asked for again
  bool equal_radii_ = true;                        // of the scene
  std::optional<Cells> planned_;                   // the cells that the buffers and parameters are for
  std::optional<bool> cell_order_;  // whether the spheres stand in cell order as they are; not known after a move
  bool cells_built_ = false;        // the cells are those of the spheres as they stand
  Order order_ = Order::scene;      // of the results
  bool index_in_w_ = false;         // of the spheres in cell order
  Params params_{};                 // of the last launch
  CollideOptions options_;
  bool tallied_ = true;  // colliding spheres are counted
  bool cleared_ = false, collided_ = false;
  bool search_decides_ = false;  // most of the pairs that the filter leaves undecided, and not only defers them
  bool resolved_ = true;         // what was deferred
  std::set<std::pair<Method, bool>> resolved_in_step_;  // searches that are settled with every step, see search()
  bool counts_sorted_ = false;                          // SLOT_COUNT lacks the counts that SLOT_SORTED_COUNT has
  View view_{};                                         // of the last draw; a width of 0: there was none
  View asked_{};                                        // the same as it was asked for
  DrawOptions draw_options_;
  std::optional<Order> clustered_;                   // whose clusters they are; none when spheres have moved
  bool moved_ = false;                               // since the upload of a scene at its start
  bool seen_known_ = false;                          // SLOT_VISIBLE, or the list made of it, has spheres of this scene
  bool pixels_kept_ = false;                         // SLOT_VISIBLE shows the last picture
  uint visible_slot_ = SLOT_VISIBLE;                 // of this picture ...
  bool overlaps_ = false;                            // ... whose spheres are drawn whether or not the last one is done
  std::array<uint64_t, SLOT_TOTAL> pixels_clear_{};  // of the two slots; the counts of SLOT_DRAWN are those of a new
                                                     // picture then
  uint first_pass_tiles_ = 0;   // that the depths of the picture needed, where its numbers take a second pass
  uint lists_turn_ = 0;         // View::turn of the next picture
  bool image_current_ = false;  // nothing has changed since the last draw
  uint64_t images_kept_ = 0;
  std::array<uint64_t, SLOT_TOTAL> bytes_{};
};

}  // namespace spherepair
