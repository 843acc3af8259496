// SPDX-License-Identifier: MIT
// Integer hashes: the scenes' random numbers and the order-independent fingerprint of a pair set.
#ifndef SPHEREPAIR_HASH_H
#define SPHEREPAIR_HASH_H

#include "common/shared/portable.h"

// The finalisers of splitmix64 (Steele, Lea, Flood 2014) and MurmurHash3 (Appleby): two unrelated bijections.
FN uint64_t splitmix64(uint64_t x) {
  x += 0x9E3779B97F4A7C15ul;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ul;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBul;
  return x ^ (x >> 31);
}

FN uint64_t murmur64(uint64_t x) {
  x = (x ^ (x >> 33)) * 0xFF51AFD7ED558CCDul;
  x = (x ^ (x >> 33)) * 0xC4CEB9FE1A85EC53ul;
  return x ^ (x >> 33);
}

// The fingerprint of a set of pairs (i<j) is the sums of these two modulo 2^64.
FN uint64_t pair_mix_a(uint i, uint j) { return splitmix64((uint64_t(i) << 32) | uint64_t(j)); }
FN uint64_t pair_mix_b(uint i, uint j) { return murmur64(((uint64_t(i) << 32) | uint64_t(j)) + 1ul); }

#endif
