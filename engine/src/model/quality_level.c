/* SPDX-License-Identifier: MIT */
#include "model/quality_level.h"

#include <math.h>

#include "model/body_kind.h"

/* Tables between modes and contact points have a number for each pair: at most so many, where a
 * model may have more modes than TB_FEW_MODES. */
static const double MOST_PAIRS = 48e6;
static const uint32_t MOST_MODES[] = {0, 4096, 4096, 8192, 16384}; /* by quality */
static const double FEW_ZERO = 91.0; /* leaves half of TB_FEW_MODES to either head */

/* Two-way modes stay below this part of the rate, where the gain of the recursion is still near 1.
 */
static const double TOP_OF_RATE = 0.2;
/* A body whose modes are all two-way is heard up to here [Hz], and to this part of the rate. There
 * the recursion answers a contact's force too loudly by w k/(2 sin(w k/2)): 1.9 dB at 17 kHz and
 * 48,000 steps a second. */
static const double ALL_HEARD = 17000.0, TOP_OF_ALL = 0.36;

/* Hoop and shell move up to here at every quality: a stick on the hoop meets their compliance [Hz].
 */
static const double RIM_TOP = 8000.0;

/* A contact's force is a mean over two steps. It is 7 dB too weak at a third of the rate, and has
 * no stiffness at a quarter of it: at 48 kHz, the treble of wires on a head is 5 to 15 dB too faint
 * at 16 kHz. The better qualities step twice per frame where the output is slower than this [Hz].
 */
static const double ENOUGH_STEPS = 88200.0;

uint32_t tb_level_steps(uint32_t quality, double sample_rate) {
  return quality >= TABOR_QUALITY_STUDIO && sample_rate < ENOUGH_STEPS ? 2 : 1;
}

/* Wavenumber times radius up to which large deflections couple a plate's modes: of a crash cymbal
 * of 16 inch 1.6, 2.6, 4 and 8 kHz, some 120, 190, 300 and 600 modes. By quality. */
static const double COUPLED[] = {0.0, 20.0, 26.0, 33.0, 46.0};

TbBodyLimits tb_level_limits(uint32_t quality, uint32_t points, double rate) {
  const double rim = fmin(RIM_TOP, TOP_OF_RATE * rate);
  if (quality < TABOR_QUALITY_STUDIO)
    return (TbBodyLimits){TB_FEW_MODES, FEW_ZERO, rim, COUPLED[quality]};
  const double fitting = MOST_PAIRS / fmax(1.0, points);
  const uint32_t modes = (uint32_t)fmin(MOST_MODES[quality], fmax(TB_FEW_MODES, fitting));
  return (TbBodyLimits){modes, fmin(TB_TOP_ZERO, floor(1.0 + sqrt(4.0 * modes))), rim,
                        COUPLED[quality]};
}

static TbLevel level_of(uint32_t quality) {
  switch (quality) {
  case TABOR_QUALITY_DRAFT:
    return (TbLevel){2500.0, 0.0, 3, 4, 32, 3e-2, 1e-2, 1e-2, TB_IN_FLOAT, TB_IN_FLOAT};
  case TABOR_QUALITY_LIVE:
    return (TbLevel){4000.0, 18000.0, 16, 16, 64, 3e-1, 3e-2, 3e-3, TB_IN_FLOAT, TB_IN_FLOAT};
  case TABOR_QUALITY_REFERENCE:
    return (TbLevel){16000.0, 18000.0, 16, 64, 256, 0.0, 1e-7, 0.0, TB_IN_DOUBLE, TB_IN_DOUBLE};
  default:
    return (TbLevel){12000.0, 18000.0, 8, 24, 128, 1e-4, 1e-2, 1e-3, TB_IN_DOUBLE, TB_IN_FLOAT};
  }
}

/* The one-way band needs no more than that its modes be told apart from their images. */
static const double TOP_OF_HEARING = 0.42;

/* Many wires share their points: half as many each, and at live 12 mm apart on a snare drum, still
 * closer than half the head's shortest wavelength. */
static const uint32_t MANY_WIRES = 8, CELLS_OF_MANY[] = {24, 24, 24, 48, 128};
/* Studio gives fewer wires than twenty more points each, as many together. */
static const uint32_t CELLS_OF_ALL = 960;

static uint32_t cells_of_many(uint32_t quality, uint32_t wires, uint32_t most) {
  if (quality != TABOR_QUALITY_STUDIO) return CELLS_OF_MANY[quality];
  const uint32_t each = CELLS_OF_ALL / wires / 2u * 2u; /* even */
  return each < CELLS_OF_MANY[quality] ? CELLS_OF_MANY[quality] : (each > most ? most : each);
}

TbLevel tb_level(const TaborDrumDef *def, uint32_t quality, double sample_rate) {
  const double step_rate = tb_level_steps(quality, sample_rate) * sample_rate;
  TbLevel level = level_of(quality);
  const bool all_two_way = tb_body_kind(def)->all_two_way;
  if (all_two_way)
    level.bandwidth = def->quality.bandwidth > 0.0 ? def->quality.bandwidth : ALL_HEARD;
  if (def->quality.two_way_bandwidth > 0.0) level.bandwidth = def->quality.two_way_bandwidth;
  if (def->quality.newton_cap > 0) level.newton_cap = def->quality.newton_cap;
  if (def->wires.count > MANY_WIRES) {
    level.wire_cells = cells_of_many(quality, def->wires.count, level.wire_cells);
  }
  if (def->quality.wire_points > 0) level.wire_cells = def->quality.wire_points;
  if (def->quality.bandwidth > 0.0) level.top = def->quality.bandwidth;
  level.bandwidth = fmin(level.bandwidth, (all_two_way ? TOP_OF_ALL : TOP_OF_RATE) * step_rate);
  level.top = fmin(level.top, TOP_OF_HEARING * sample_rate);
  return level;
}
