#version 450
// SPDX-License-Identifier: MIT
// One group per 2^order_bits rows, LIST_ORDER_ROWS at most: sorts the keys of each row, and writes its columns. If all
// rows are short, a key's place is the number of smaller keys. Otherwise each row is sorted in chunks, and a key's
// place is the sum of its places in all chunks. A row that does not fit in shared memory is done in several ranges of
// keys.
#include "shaders/list/list_length.glsl"

layout(std430, binding = SLOT_LIST_KEY) restrict readonly buffer ListKeyBuffer { uint list_keys[]; };
layout(std430, binding = SLOT_LIST_FIRST) restrict writeonly buffer ListFirstBuffer { uint list_first[]; };
layout(std430, binding = SLOT_LIST_SECOND) restrict writeonly buffer ListSecondBuffer { uint list_second[]; };
layout(std430, binding = SLOT_LIST_SHIFT) restrict writeonly buffer ListShiftBuffer { int list_shift[]; };
layout(local_size_x = LIST_ORDER_BLOCK) in;

const uint KEYS_EACH = LIST_CHUNK / 32u;  // of a thread that sorts a chunk with 31 others

shared uint keys[LIST_ROOM];
shared uint ordered[LIST_ROOM];
shared uint row_begin[LIST_ORDER_ROWS + 1u];  // less that of the first
shared uint has_long_row;
shared uint found;
// GLSL only from here: threads exchange values through registers where group_sum.glsl does
#ifdef SUBGROUPS
uint exchanged(uint value, uint mask) { return subgroupShuffleXor(value, mask); }
#else
shared uint passed[LIST_ORDER_BLOCK];
uint exchanged(uint value, uint mask) {
  barrier();
  passed[gl_LocalInvocationID.x] = value;
  barrier();
  return passed[gl_LocalInvocationID.x ^ mask];
}
#endif
// until here

// What the keys of a row have in common.
struct RowKeys {
  ivec4 place;                // of the point or query
  uint first_point, bits;     // of the system; of an image's number
  ivec4 images;               // of the system, to either side
  uint along_y, along_z, at;  // numbers of images; the number of (0, 0, 0)
};
RowKeys keys_of_row(uint i, uint flags) {
  RowKeys row;
  row.place = list_place[(flags & LIST_ASKS) != 0u ? list_state[0].points + i : i];
  uint s = uint(row.place.w);
  row.first_point = list_system[s].first_point;
  row.bits = list_system[s].key_bits;
  row.images = ivec4(int(list_system[s].images[0]), int(list_system[s].images[1]), int(list_system[s].images[2]), 0);
  row.along_y = 2u * uint(row.images.y) + 1u;
  row.along_z = 2u * uint(row.images.z) + 1u;
  row.at = (uint(row.images.x) * row.along_y + uint(row.images.y)) * row.along_z + uint(row.images.z);
  return row;
}

ivec4 image_of(RowKeys row, uint number) {
  if (number == row.at) return ivec4(0, 0, 0, 0);
  uint x_and_y = number / row.along_z;
  uint x = x_and_y / row.along_y;
  return ivec4(int(x) - row.images.x, int(x_and_y - x * row.along_y) - row.images.y,
               int(number - x_and_y * row.along_z) - row.images.z, 0);
}

void write_pair(RowKeys row, uint i, uint64_t at, uint key, uint flags) {
  uint j = row.first_point + (key >> row.bits);
  if ((flags & LIST_WANTS_SHIFTS) != 0u) {
    ivec4 image = image_of(row, key & ((1u << row.bits) - 1u));
    ivec4 other = list_place[j];
    list_shift[3u * column_index(at)] = image.x + row.place.x - other.x;
    list_shift[3u * column_index(at) + 1u] = image.y + row.place.y - other.y;
    list_shift[3u * column_index(at) + 2u] = image.z + row.place.z - other.z;
  }
  if ((flags & LIST_WANTS_FIRST) != 0u) list_first[column_index(at)] = i;
  if ((flags & LIST_WANTS_SECOND) != 0u) list_second[column_index(at)] = j;
}

// The row that has the k-th key of the group.
uint row_of_key(uint k) {
  uint row = 0u;
  for (uint step = LIST_ORDER_ROWS / 2u; step != 0u; step /= 2u)
    if (row_begin[row + step] <= k) row += step;
  return row;
}

// Sorts rows from..to-1 of the group, and writes their columns.
void order_short_rows(uint first, uint from, uint to, uint flags) {
  uint64_t begin = uint64_t(list_begin[first]) + uint64_t(row_begin[from]);
  uint before = row_begin[from];
  uint total = row_begin[to] - before;
  for (uint k = gl_LocalInvocationID.x; k < total; k += LIST_ORDER_BLOCK) {
    uint row = row_of_key(before + k);
    uint n = before + k - row_begin[row];
    keys[k] = list_keys[column_index(keys_at(first + row, row_begin[row + 1u] - row_begin[row]) + uint64_t(n))];
  }
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < total; k += LIST_ORDER_BLOCK) {
    uint row = row_of_key(before + k);
    uint end = row_begin[row + 1u] - before;
    uint key = keys[k];
    uint place = row_begin[row] - before;
    for (uint n = place; n < end; ++n) place += uint(keys[n] < key);
    ordered[place] = key;
  }
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < total; k += LIST_ORDER_BLOCK) {
    uint i = first + row_of_key(before + k);
    write_pair(keys_of_row(i, flags), i, begin + uint64_t(k), ordered[k], flags);
  }
  barrier();
}

// Sorts a chunk of keys by 32 threads, bitonic. Each then holds KEYS_EACH consecutive keys.
void sort_chunk(uint begin, uint count) {
  uint lane = gl_LocalInvocationID.x % 32u;
  uint own[KEYS_EACH];
  for (uint r = 0u; r < KEYS_EACH; ++r) {
    uint k = begin + r * 32u + lane;
    own[r] = k < count ? keys[k] : ~0u;
  }
  barrier();
  for (uint bits = 1u; bits <= LIST_CHUNK_BITS; ++bits) {
    for (uint down = 1u; down <= bits; ++down) {
      uint stride = 1u << (bits - down);
      for (uint r = 0u; r < KEYS_EACH; ++r) {
        bool ascends = ((lane * KEYS_EACH + r) >> bits & 1u) == 0u;
        if (stride >= KEYS_EACH) {
          uint other = exchanged(own[r], stride / KEYS_EACH);
          bool first = (lane & (stride / KEYS_EACH)) == 0u;
          own[r] = first == ascends ? min(own[r], other) : max(own[r], other);
        } else if ((r & stride) == 0u) {
          uint low = min(own[r], own[r + stride]);
          uint high = max(own[r], own[r + stride]);
          own[r] = ascends ? low : high;
          own[r + stride] = ascends ? high : low;
        }
      }
    }
  }
  for (uint r = 0u; r < KEYS_EACH; ++r)
    if (begin < count) keys[begin + lane * KEYS_EACH + r] = own[r];
}

// Returns how many keys of a sorted chunk are smaller.
uint smaller_in_chunk(uint chunk, uint key) {
  uint rank = 0u;
  for (uint step = LIST_CHUNK / 2u; step != 0u; step /= 2u)
    if (keys[chunk * LIST_CHUNK + rank + step - 1u] < key) rank += step;
  return rank + uint(keys[chunk * LIST_CHUNK + rank] < key);
}

void write_sorted(uint i, uint64_t begin, uint count, uint flags) {
  uint thread = gl_LocalInvocationID.x;
  uint chunks = (count + LIST_CHUNK - 1u) / LIST_CHUNK;
  for (uint chunk = 0u; chunk < chunks; chunk += LIST_ORDER_BLOCK / 32u)
    sort_chunk((chunk + thread / 32u) * LIST_CHUNK, count);
  barrier();
  for (uint k = thread; k < count; k += LIST_ORDER_BLOCK) {
    uint rank = k % LIST_CHUNK;
    for (uint chunk = 0u; chunk < chunks; ++chunk)
      if (chunk != k / LIST_CHUNK) rank += smaller_in_chunk(chunk, keys[k]);
    ordered[rank] = keys[k];
  }
  barrier();
  RowKeys row = keys_of_row(i, flags);
  for (uint k = thread; k < count; k += LIST_ORDER_BLOCK) write_pair(row, i, begin + uint64_t(k), ordered[k], flags);
  barrier();
}

// Copies the keys low <= key < high to shared memory, LIST_ROOM at most. Returns how many there are.
uint keys_between(uint64_t first, uint length, uint64_t low, uint64_t high) {
  barrier();
  if (gl_LocalInvocationID.x == 0u) found = 0u;
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < length; k += LIST_ORDER_BLOCK) {
    uint key = list_keys[column_index(first + uint64_t(k))];
    if (uint64_t(key) < low || uint64_t(key) >= high) continue;
    uint n = atomicAdd(found, 1u);
    if (n < LIST_ROOM) keys[n] = key;
  }
  barrier();
  return found;
}

void order_long_row(uint i, uint flags) {
  uint64_t row = uint64_t(list_begin[i]);
  uint length = row_length[i];
  uint64_t first = keys_at(i, length);
  if (length <= LIST_ROOM) {
    for (uint k = gl_LocalInvocationID.x; k < length; k += LIST_ORDER_BLOCK)
      keys[k] = list_keys[column_index(first + uint64_t(k))];
    barrier();
    write_sorted(i, row, length, flags);
    return;
  }
  uint64_t written = uint64_t(0u);
  uint64_t low = uint64_t(0u);
  uint64_t step = uint64_t(1u) << 32;
  while (written < uint64_t(length)) {
    uint count = keys_between(first, length, low, low + step);
    if (count > LIST_ROOM) {
      step = step >> 1;
      continue;
    }
    write_sorted(i, row + written, count, flags);
    written += uint64_t(count);
    low += step;
    if (count < LIST_ROOM / 4u) step = step << 1;
  }
}

void main() {
  uint looking = list_state[0].looking;
  uint first = group_index() << list_state[0].order_bits;
  if (first >= looking || !is_right() || !has_room()) return;
  uint rows = min(1u << list_state[0].order_bits, looking - first);
  uint thread = gl_LocalInvocationID.x;
  if (thread == 0u) has_long_row = 0u;
  barrier();
  if (thread <= LIST_ORDER_ROWS) row_begin[thread] = uint(list_begin[first + min(thread, rows)] - list_begin[first]);
  if (thread < rows && row_length[first + thread] > LIST_RANKED) atomicAdd(has_long_row, 1u);
  barrier();
  uint flags = list_state[0].flags;
  if (has_long_row == 0u) {
    uint half_group = LIST_ORDER_ROWS / 2u;
    uint middle = row_begin[LIST_ORDER_ROWS] > LIST_ROOM ? half_group : LIST_ORDER_ROWS;
    order_short_rows(first, 0u, middle, flags);
    if (middle == half_group) order_short_rows(first, middle, LIST_ORDER_ROWS, flags);
  } else {
    for (uint row = 0u; row < rows; ++row) order_long_row(first + row, flags);
  }
}
