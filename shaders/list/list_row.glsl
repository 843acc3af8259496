// SPDX-License-Identifier: MIT
// The pairs of a group's rows. Rows of systems with many points within reach look together: each row, a lane of its
// own, tests the points that the group has staged. Others, and queries, look alone.
#include "shaders/list/list_region.glsl"
#include "shaders/list/list_wanted.glsl"

layout(std430, binding = SLOT_LIST_KEY) restrict writeonly buffer ListKeyBuffer { uint list_keys[]; };

const uint WORDS = LONG_ROWS ? uint(BLOCK) : 1u;  // GLSL only: drivers keep arrays that nobody uses
shared uint found[LIST_ROWS];                     // pairs of each row
shared uint word_bits[WORDS];       // of each thread, for write_words: the staged points that are listed, ...
shared uint64_t word_first[WORDS];  // ... and where the first of their keys goes

// Room for the keys of a row.
struct KeyRange {
  uint64_t first;
  uint count;
};

// Tests a point in float32 and appends the result as the lowest bit: in x if the point is certainly within reach, in y
// also if float32 cannot decide.
uvec2 with_test(uvec2 bits, vec4 place, vec4 other, float tolerance) {
  EXACT float x = other.x - place.x;
  EXACT float y = other.y - place.y;
  EXACT float z = other.z - place.z;
  EXACT float reach = place.w + other.w;
  float beyond = list_beyond(x, y, z, reach);
  EXACT float most = beyond + tolerance;
  EXACT float least = beyond - tolerance;
  return uvec2(bits.x << 1 | float_bits(most) >> 31, bits.y << 1 | float_bits(least) >> 31);
}

// Up to 32 points that a row has tested: the staged ones before `end`, or those of a range before it.
struct Tested {
  uvec2 bits;
  uint begin, end, image;  // of the range; LIST_NO_RANGE: staged
};
uint key_of_bit(Region region, Tested tested, uint bits) {
  uint at = tested.end - 1u - lowest_bit(bits);
  return tested.image == LIST_NO_RANGE ? staged_key[at] : key_in_range(region, at, tested.image);
}

// Returns in x the bits of the points that the list pairs with the row's, in y those that float32 leaves undecided.
// With `exact` these are decided on the numbers as given, and x has no others; otherwise x lacks them. own: where the
// row's own point is.
uvec2 listed_points(Region region, uint i, Tested tested, uint own, bool exact) {
  uvec2 bits = tested.bits;
  bool all = lists_all();
  if (all && own >= tested.begin && own < tested.end) {
    uint others = ~(1u << (tested.end - 1u - own));
    bits = uvec2(bits.x & others, bits.y & others);
  }
  uint undecided = bits.y & ~bits.x;
  uint listed = exact ? undecided : bits.x;
  uint open = all && !exact ? 0u : listed;
  while (open != 0u) {
    uint bit = open & (~open + 1u);
    uint key = key_of_bit(region, tested, open);
    open ^= bit;
    uint j = region.first_point + (key >> region.key_bits);
    ivec4 image = image_of(images_of(region.look.system), key & ((1u << region.key_bits) - 1u));
    bool is_pair = is_wanted(i, j, image);
    if (exact && is_pair) is_pair = is_within_reach(i, j, image);
    listed = is_pair ? listed : listed & ~bit;
  }
  return uvec2(listed, undecided);
}

// Adds pairs to a row. Writes their keys as far as there is room, or leaves them to write_words. Returns the bits that
// are undecided.
uint add_pairs(Region region, uint i, Tested tested, uint own, KeyRange to, bool together, bool exact) {
  uvec2 points = listed_points(region, i, tested, own, exact);
  uint listed = points.x;
  if (listed == 0u) return points.y;
  uint n = atomicAdd(found[lane_of_row()], count_bits(listed));
  if (together) {
    while (listed != 0u && n + count_bits(listed) > to.count) listed &= listed - 1u;
    word_bits[gl_LocalInvocationID.x] = listed;
    word_first[gl_LocalInvocationID.x] = to.first + uint64_t(n);
    return points.y;
  }
  for (; listed != 0u && n < to.count; ++n) {
    list_keys[column_index(to.first + uint64_t(n))] = key_of_bit(region, tested, listed);
    listed &= listed - 1u;
  }
  return points.y;
}

// Writes the keys of the words of all threads. A word has up to 2^row_bits bits; as many neighbouring threads write its
// keys side by side.
void write_words(uint first, uint end, uint share) {
  uint bits = list_state[0].row_bits;
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < group_threads() << bits; k += group_threads()) {
    uint word = k >> bits;
    uint bit = k & (group_rows() - 1u);
    if ((word_bits[word] >> bit & 1u) != 0u) {
      uint n = count_bits(word_bits[word] & ((1u << bit) - 1u));
      uint tested = min(first + ((word >> bits) + 1u) * share, end);
      list_keys[column_index(word_first[word] + uint64_t(n))] = staged_key[tested - 1u - bit];
    }
  }
}

// Tests the staged points from the first on, a share for each thread of a row that joins. All threads of a group call
// this. Returns the bits that are undecided.
uint test_staged(Region region, uint i, vec4 place, bool joins, bool together, uint first, uint end, KeyRange to,
                 bool exact) {
  uint bits = list_state[0].row_bits;
  uint threads = group_threads() >> bits;
  uint share = (end - first + threads - 1u) / threads;
  Tested tested;
  tested.bits = uvec2(0u, 0u);
  tested.begin = first + (gl_LocalInvocationID.x >> bits) * share;
  tested.end = min(tested.begin + share, end);
  tested.image = LIST_NO_RANGE;
  if (together) word_bits[gl_LocalInvocationID.x] = 0u;
  uint undecided = 0u;
  if (joins && tested.begin < tested.end) {
    float tolerance = list_system[region.look.system].tolerance;
    for (uint at = tested.begin; at < tested.end; ++at)
      tested.bits = with_test(tested.bits, place, staged_point[at], tolerance);
    undecided = add_pairs(region, i, tested, own_point[lane_of_row()], to, together, exact);
  }
  if (together) write_words(first, end, share);
  return undecided;
}

// Looks through the region of the rows that look together. Returns not 0 if pairs of this row are undecided.
uint look_through(uint i, vec4 place, bool joins, bool together, uint first_row, KeyRange to, bool exact) {
  uint thread = gl_LocalInvocationID.x;
  float tolerance = list_system[leading.system].tolerance;
  RowBox box = box_of_rows();
  Region region = region_of_rows();
  uint undecided = 0u;
  if (thread == 0u) staged = 0u;
  if (thread < group_rows()) own_point[thread] = ~0u;
  for (uint first = 0u; first < region.ranges; first += LIST_RANGES) {
    set_ranges(region, first);
    uint points = range_upto[LIST_RANGES];
    for (uint k = 0u; k < points; k += group_threads()) {
      if (k + thread < points) stage(region, box, tolerance, k + thread, first_row);
      barrier();
      uint have = staged;
      bool tests = have >= group_threads();
      if (tests) undecided |= test_staged(region, i, place, joins, together, have - group_threads(), have, to, exact);
      barrier();
      if (tests && thread == 0u) staged = have - group_threads();
      if (tests && thread < group_rows() && own_point[thread] >= have - group_threads()) own_point[thread] = ~0u;
      barrier();
    }
  }
  return undecided | test_staged(region, i, place, joins, together, 0u, staged, to, exact);
}

// Looks through the cells within a row's reach, whose ranges its threads share. Returns not 0 if pairs are undecided.
uint look_alone(ListLook look, vec4 place, uint own, KeyRange to, bool exact) {
  uint bits = list_state[0].row_bits;
  float tolerance = list_system[look.system].tolerance;
  Region region = region_of(look);
  uint undecided = 0u;
  for (uint number = gl_LocalInvocationID.x >> bits; number < region.ranges; number += group_threads() >> bits) {
    PointRange range = range_of(region, number);
    Tested tested;
    tested.image = range.image;
    for (tested.begin = range.begin; tested.begin < range.end; tested.begin = tested.end) {
      tested.end = min(tested.begin + 32u, range.end);
      tested.bits = uvec2(0u, 0u);
      for (uint at = tested.begin; at < tested.end; ++at)
        tested.bits = with_test(tested.bits, place, place_in_range(at, range.shift), tolerance);
      if (tested.bits.y != 0u)
        undecided |= add_pairs(region, look.i, tested, range.image == region.no_image ? own : ~0u, to, false, exact);
    }
  }
  return undecided;
}

// All threads of a group call this. Row k is one of the group's, from the first on.
void find_pairs(uint k, bool looks, bool together, uint first_row, KeyRange to) {
  ListLook look = list_look[looks ? k : first_row];
  vec4 place = sorted[(has_flag(LIST_ASKS) ? list_state[0].points : 0u) + (looks ? k : first_row)];
  EXACT float part = list_system[look.system].reach_part + place.w;
  place.w = part;
  barrier();  // `found` is 0
  bool waits = looks && look.low[0] < look.high[0] && look.low[1] < look.high[1] && look.low[2] < look.high[2];
  if (waits && list_system[look.system].looks_alone != 0u) {
    waits = false;
    uint own = has_flag(LIST_ASKS) ? ~0u : k;
    if (look_alone(look, place, own, to, false) != 0u) look_alone(look, place, own, to, true);
  }
  while (true) {
    bool joins = joins_leader(look, waits);
    if (leader == LIST_ROWS) return;
    waits = waits && !joins;
    bound_rows(look, place, joins);
    if (look_through(look.i, place, joins, together, first_row, to, false) != 0u) undecided_rows = 1u;
    barrier();
    if (undecided_rows != 0u) look_through(look.i, place, joins, together, first_row, to, true);
  }
}
