/* A range coder of bits whose probabilities are learned. C99, no allocation.
 *
 * Each function codes in both directions: a reader answers with what was written, a writer with what it was given. So
 * whatever stands on top of it is one text for both directions, and they can not come apart.
 *
 * Martin: Range encoding, an algorithm for removing redundancy from a digitised message, 1979; of bits, so that each
 * has a probability of its own: the mean of a fast and of a slow estimate.
 */
#ifndef FOREDRAW_RUNTIME_RANGE_CODER_H
#define FOREDRAW_RUNTIME_RANGE_CODER_H

#include <stddef.h>
#include <stdint.h>

/* How likely a bit is 0, of 65,536. */
typedef struct foredraw_bit_model {
  uint16_t fast, slow;
} foredraw_bit_model;

/* Reads or writes one run of bytes. */
typedef struct foredraw_range_coder {
  uint32_t range;
  uint32_t code;      /* reader: where in the range */
  uint64_t low;       /* writer */
  uint32_t held;      /* writer: bytes that a carry may still change, the first of which is `first_held` */
  uint8_t first_held; /* writer */
  int writes;
  int failed;           /* reader: wanted more than there is; writer: there is no room */
  const uint8_t* input; /* reader: the next byte */
  uint8_t* output;      /* writer: where the next byte goes */
  size_t left;          /* bytes of the input or the room */
} foredraw_range_coder;

static inline void foredraw_models_begin(foredraw_bit_model* models, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) models[i].fast = models[i].slow = 32768;
}

static inline uint32_t foredraw_next_byte(foredraw_range_coder* coder) {
  if (coder->left == 0) {
    coder->failed = 1;
    return 0;
  }
  --coder->left;
  return *coder->input++;
}

static inline void foredraw_reader_begin(foredraw_range_coder* coder, const uint8_t* bytes, size_t count) {
  int i;
  coder->range = 0xffffffffu;
  coder->code = 0;
  coder->writes = 0;
  coder->failed = 0;
  coder->input = bytes;
  coder->left = count;
  for (i = 0; i < 4; ++i) coder->code = coder->code << 8 | foredraw_next_byte(coder);
}

static inline void foredraw_writer_begin(foredraw_range_coder* coder, uint8_t* room, size_t count) {
  coder->range = 0xffffffffu;
  coder->low = 0;
  coder->held = 0;
  coder->first_held = 0;
  coder->writes = 1;
  coder->failed = 0;
  coder->output = room;
  coder->left = count;
}

static inline void foredraw_put_byte(foredraw_range_coder* coder, uint32_t byte) {
  if (coder->left == 0) {
    coder->failed = 1;
    return;
  }
  --coder->left;
  *coder->output++ = (uint8_t)byte;
}

/* The writer's topmost byte leaves; while it is 255 a carry may still come, and it is held. */
static inline void foredraw_shift_low(foredraw_range_coder* coder) {
  const uint32_t carry = (uint32_t)(coder->low >> 32);
  if (coder->held == 0 || carry != 0 || (uint32_t)coder->low < 0xff000000u) {
    if (coder->held > 0) foredraw_put_byte(coder, coder->first_held + carry);
    for (; coder->held > 1; --coder->held) foredraw_put_byte(coder, 0xffu + carry);
    coder->held = 0;
    coder->first_held = (uint8_t)(coder->low >> 24);
  }
  ++coder->held;
  coder->low = (uint64_t)((uint32_t)coder->low << 8);
}

/* Ends what the writer wrote; a reader that is given all of it wants no more. */
static inline void foredraw_writer_end(foredraw_range_coder* coder) {
  int i;
  for (i = 0; i < 5; ++i) foredraw_shift_low(coder);
}

static inline void foredraw_normalize(foredraw_range_coder* coder) {
  while (coder->range < 1u << 24) {
    coder->range <<= 8;
    if (coder->writes) {
      foredraw_shift_low(coder);
    } else {
      coder->code = coder->code << 8 | foredraw_next_byte(coder);
    }
  }
}

static inline uint32_t foredraw_code_bit(foredraw_range_coder* coder, foredraw_bit_model* model, uint32_t bit) {
  const uint32_t zero = (coder->range >> 15) * (((uint32_t)model->fast + model->slow) >> 2);
  if (!coder->writes) bit = coder->code >= zero;
  if (bit) {
    if (coder->writes) {
      coder->low += zero;
    } else {
      coder->code -= zero;
    }
    coder->range -= zero;
    model->fast = (uint16_t)(model->fast - (model->fast >> 4));
    model->slow = (uint16_t)(model->slow - (model->slow >> 7));
  } else {
    coder->range = zero;
    model->fast = (uint16_t)(model->fast + ((65536u - model->fast) >> 4));
    model->slow = (uint16_t)(model->slow + ((65536u - model->slow) >> 7));
  }
  foredraw_normalize(coder);
  return bit;
}

/* `count` bits, at most 16, that are as likely 0 as 1. */
static inline uint32_t foredraw_code_plain_bits(foredraw_range_coder* coder, uint32_t count, uint32_t value) {
  const uint32_t step = coder->range >> count;
  if (coder->writes) {
    coder->low += (uint64_t)step * value;
  } else {
    value = coder->code / step;
    if (value >> count != 0) {
      value = (1u << count) - 1;
      coder->failed = 1;
    }
    coder->code -= step * value;
  }
  coder->range = step;
  foredraw_normalize(coder);
  return value;
}

/* A number below 2^bits; `models`: as many. */
static inline uint32_t foredraw_code_symbol(foredraw_range_coder* coder, foredraw_bit_model* models, uint32_t bits,
                                            uint32_t value) {
  uint32_t node = 1, i;
  for (i = bits; i-- > 0;) node = node << 1 | foredraw_code_bit(coder, models + node, value >> i & 1);
  return node - (1u << bits);
}

static inline uint32_t foredraw_bit_count(uint64_t value) {
  uint32_t count = 0, step;
  for (step = 32; step > 0; step /= 2) {
    if (value >> step != 0) {
      count += step;
      value >>= step;
    }
  }
  return count + (uint32_t)value;
}

/* A whole number: how many bits its amount has, its sign, the next two bits, and the rest. */
typedef struct foredraw_number_model {
  foredraw_bit_model bits[32];
  foredraw_bit_model sign[2]; /* of 0 and -1, and of others */
  foredraw_bit_model next[32][4];
} foredraw_number_model;

static inline int32_t foredraw_code_number(foredraw_range_coder* coder, foredraw_number_model* model, int32_t value) {
  const uint32_t amount = value < 0 ? ~(uint32_t)value : (uint32_t)value; /* -1 is beside 0, -2 beside 1 */
  const uint32_t bits = foredraw_code_symbol(coder, model->bits, 5, foredraw_bit_count(amount));
  const uint32_t is_negative = foredraw_code_bit(coder, &model->sign[bits > 0], value < 0);
  uint32_t result = bits > 0, rest = bits > 0 ? bits - 1 : 0, part = rest < 2 ? rest : 2;
  if (part > 0) {
    rest -= part;
    result = result << part | foredraw_code_symbol(coder, model->next[bits], part, amount >> rest & ((1u << part) - 1));
  }
  while (rest > 0) {
    part = rest < 16 ? rest : 16;
    rest -= part;
    result = result << part | foredraw_code_plain_bits(coder, part, amount >> rest & ((1u << part) - 1));
  }
  return is_negative ? -(int32_t)result - 1 : (int32_t)result;
}

#endif
