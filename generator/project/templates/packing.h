// @MODULE@: numbers to the bytes of its streams and back, for C and C++.
//
@HEAD@
//
@EXAMPLE@
//
// Floating point: a double is rounded to nearest, ties to even; overflow gives infinity. Fixed point:
// the format must hold the number; one with digits behind the point is a double as well, so that
// formats of more than 53 bits have numbers that are rounded when they are unpacked. Operands lie
// side by side without gaps, the first lowest.
@IF NO_INFINITIES@
//
// E4M3 has no infinities: they, and numbers that round to more than 448, become its NaN.
@END@

#ifndef @NAME@_PACKING_H
#define @NAME@_PACKING_H

@IF WIDE@
#include <math.h>
@END@
#include <stdint.h>
#include <string.h>

// Writes the low `bits` bits of a word from bit `at` on. They must be zero before.
static inline void @MODULE@_put(uint8_t *bytes, int at, int bits, uint64_t word) {
  for (int done = 0; done < bits;) {
    const int place = (at + done) % 8;
    const int taken = bits - done < 8 - place ? bits - done : 8 - place;
    bytes[(at + done) / 8] |= (uint8_t)((word >> done & (0xffu >> (8 - taken))) << place);
    done += taken;
  }
}

// The `bits` bits from bit `at` on.
static inline uint64_t @MODULE@_get(const uint8_t *bytes, int at, int bits) {
  uint64_t word = 0;
  for (int done = 0; done < bits;) {
    const int place = (at + done) % 8;
    const int taken = bits - done < 8 - place ? bits - done : 8 - place;
    word |= (uint64_t)(bytes[(at + done) / 8] >> place & (0xff >> (8 - taken))) << done;
    done += taken;
  }
  return word;
}

// The same in two's complement.
static inline int64_t @MODULE@_get_signed(const uint8_t *bytes, int at, int bits) {
  const uint64_t sign = (uint64_t)1 << (bits - 1);
  return (int64_t)((@MODULE@_get(bytes, at, bits) ^ sign) - sign);
}
@IF FRACTIONS@

// Whether a number of steps is an integer from `least` to less than `limit`.
static inline int @MODULE@_holds(double steps, double least, double limit) {
  const double all_are_integers = 9007199254740992.0;
  return steps >= least && steps < limit &&
         (steps >= all_are_integers || (double)(int64_t)steps == steps);
}
@END@
@IF FLOATS@

// value / 2^dropped, rounded to the nearest integer, of two to the even one.
static inline uint64_t @MODULE@_rounded(uint64_t value, int dropped) {
  if (dropped == 0) return value;
  return (value + ((uint64_t)1 << (dropped - 1)) - 1 + (value >> dropped & 1)) >> dropped;
}

// The word of a double, for formats whose numbers are all doubles: as IEEE 754 packs, the fraction
// lowest, then the exponent, then the sign.
static inline uint64_t @MODULE@_word(double value, int digits, int exponent_bits) {
  const int dropped = 53 - digits;
  const int bias_change = 1024 - (1 << (exponent_bits - 1));
  const uint64_t infinity = (((uint64_t)1 << exponent_bits) - 1) << (digits - 1);
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  const uint64_t sign = bits >> 63 << (digits - 1 + exponent_bits);
  bits &= UINT64_MAX >> 1;
  const int exponent = (int)(bits >> 52);
  if (exponent == 0x7ff && bits << 12 > 0) return infinity | (uint64_t)1 << (digits - 2);  // a NaN
  if (bias_change > 0 && exponent <= bias_change) {                   // less than a normal number
    const int below = dropped + bias_change + 1 - exponent;
    const uint64_t significand = (bits & UINT64_MAX >> 12) | (uint64_t)1 << 52;
    return sign | (below > 54 ? 0 : @MODULE@_rounded(significand, below));
  }
  const uint64_t word =
      @MODULE@_rounded(bits, dropped) - ((uint64_t)bias_change << (digits - 1));
  return sign | (word < infinity ? word : infinity);
}

static inline double @MODULE@_number(uint64_t word, int digits, int exponent_bits) {
  const int dropped = 53 - digits;
  const int bias_change = 1024 - (1 << (exponent_bits - 1));
  const uint64_t sign = (uint64_t)1 << (digits - 1 + exponent_bits);
  const uint64_t magnitude = word & (sign - 1);
  const int exponent = (int)(magnitude >> (digits - 1));
  double number;
  uint64_t bits = (magnitude << dropped) + ((uint64_t)bias_change << 52);
  if (exponent == (1 << exponent_bits) - 1) bits |= (uint64_t)0x7ff << 52;
  if (exponent == 0 && bias_change > 0) {                             // units of the least number
    const uint64_t unit = (uint64_t)(bias_change + 2 - digits) << 52;
    memcpy(&number, &unit, sizeof number);
    number *= (double)magnitude;
    memcpy(&bits, &number, sizeof bits);
  }
  if ((word & sign) > 0) bits |= (uint64_t)1 << 63;
  memcpy(&number, &bits, sizeof number);
  return number;
}
@END@
@IF NO_INFINITIES@

// The same for a format without infinities, whose NaN is all ones below the sign. Its other words
// are those of 1 / scale of its numbers in a format with one exponent bit more.
static inline uint64_t @MODULE@_word_no_infinities(
    double value, int digits, int exponent_bits, double scale) {
  const int magnitude_bits = digits - 1 + exponent_bits;
  const uint64_t nan = ((uint64_t)1 << magnitude_bits) - 1;
  const uint64_t word = @MODULE@_word(value / scale, digits, exponent_bits + 1);
  const uint64_t magnitude = word & (2 * nan + 1);
  return magnitude < nan ? magnitude | (word >> (magnitude_bits + 1) << magnitude_bits) : nan;
}

static inline double @MODULE@_number_no_infinities(
    uint64_t word, int digits, int exponent_bits, double scale) {
  const int magnitude_bits = digits - 1 + exponent_bits;
  const uint64_t nan = ((uint64_t)1 << magnitude_bits) - 1;
  const uint64_t magnitude = word & nan;
  const uint64_t leading = (word >> magnitude_bits << 1 | (magnitude == nan)) << magnitude_bits;
  return @MODULE@_number(leading | magnitude, digits, exponent_bits + 1) * scale;
}
@END@
@IF WIDE@

// Writes a double in a format with more than 53 digits or 11 exponent bits.
static inline void @MODULE@_put_wide(
    uint8_t *bytes, int at, int digits, int exponent_bits, double value) {
  const int fraction_bits = digits - 1;
  const int largest = (1 << exponent_bits) - 1;     // of the exponent's field
  const int least = 1 - largest / 2;                // exponent of the least normal number
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  int exponent = (int)(bits >> 52 & 0x7ff);
  uint64_t significand = bits & (((uint64_t)1 << 52) - 1);
  uint64_t sign = bits >> 63, low = 0, high = 0;
  int field = largest;
  if (exponent < 0x7ff) {                           // value = significand 2^(exponent - 52)
    if (exponent > 0) significand |= (uint64_t)1 << 52;
    exponent = (exponent > 0 ? exponent : 1) - 1023;
    if (significand == 0) exponent = least;
    while (significand > 0 && significand >> 52 == 0 && exponent > least) {
      significand <<= 1;
      --exponent;
    }
    const int place = exponent > least ? exponent : least;
    const int up = exponent - place + digits - 53;  // to steps of the format
    if (up < -63) {
      low = 0;
    } else if (up < 0) {
      const uint64_t below = ((uint64_t)1 << (-up - 1)) - 1;
      low = (significand + below + (significand >> -up & 1)) >> -up;
    } else {
      low = significand << up;
      high = up > 0 ? significand >> (64 - up) : 0;
    }
    const uint64_t leading = fraction_bits < 64 ? low >> fraction_bits : high >> (fraction_bits - 64);
    field = place - least + (int)leading;
    if (field >= largest) {
      field = largest;
      low = high = 0;
    }
  } else if (significand > 0) {                     // a NaN, the quiet one
    sign = 0;
    if (fraction_bits <= 64) low = (uint64_t)1 << (fraction_bits - 1);
    else high = (uint64_t)1 << (fraction_bits - 65);
  }
  @MODULE@_put(bytes, at, fraction_bits < 64 ? fraction_bits : 64, low);
  @MODULE@_put(bytes, at + 64, fraction_bits - 64, high);
  @MODULE@_put(bytes, at + fraction_bits, exponent_bits, (uint64_t)field);
  @MODULE@_put(bytes, at + fraction_bits + exponent_bits, 1, sign);
}

// The nearest double. Below 2^-1022 it is rounded twice and may be off by one place.
static inline double @MODULE@_get_wide(
    const uint8_t *bytes, int at, int digits, int exponent_bits) {
  const int fraction_bits = digits - 1;
  const int largest = (1 << exponent_bits) - 1;
  uint64_t low = @MODULE@_get(bytes, at, fraction_bits < 64 ? fraction_bits : 64);
  uint64_t high = @MODULE@_get(bytes, at + 64, fraction_bits - 64);
  const int field = (int)@MODULE@_get(bytes, at + fraction_bits, exponent_bits);
  const double sign = @MODULE@_get(bytes, at + fraction_bits + exponent_bits, 1) > 0 ? -1 : 1;
  if (field == largest) return low > 0 || high > 0 ? (double)NAN : sign * (double)INFINITY;
  if (field > 0 && fraction_bits < 64) low |= (uint64_t)1 << fraction_bits;
  if (field > 0 && fraction_bits >= 64) high |= (uint64_t)1 << (fraction_bits - 64);
  int exponent = (field > 0 ? field : 1) - largest / 2 - fraction_bits;
  while (high > 0) {                                // the last bit keeps what falls off
    low = low >> 1 | (low & 1) | high << 63;
    high >>= 1;
    ++exponent;
  }
  return sign * ldexp((double)low, exponent);
}
@END@

@RECORDS@

#endif
