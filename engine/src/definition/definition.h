/* SPDX-License-Identifier: MIT */
/**
 * @file definition.h
 * What the model takes from a definition beyond its plain fields.
 */
#ifndef TABOR_SRC_DEFINITION_H
#define TABOR_SRC_DEFINITION_H

#include "tabor/tabor.h"

/**
 * The complete values of wire @p index (from 0) of a valid definition, none of them NaN: its own
 * ones where they are set, those of [wires] otherwise.
 *
 * - tension: with the spread applied, T (1 + spread u), u in [-1, 1] from seed and index; a wire's
 *   own tension is taken as it is. The spread may carry it past the range of the key.
 * - angle: wires.angle unless its own.
 * - offset: wires.offset + (index - (count - 1)/2) spacing unless its own.
 *
 * Integer arithmetic and exactly rounded operations only: the same on every machine.
 */
void tb_wire_resolve(const TaborDrumDef *def, unsigned index, TaborWireDef *wire);

/** Uniform number in [-1, 1] that belongs to @p seed and the index of a wire or lug. */
double tb_deviate(uint32_t seed, uint32_t index);

/** Index of the striker that strike.striker names ("" is the first), or -1. */
int tb_strike_striker(const TaborDrumDef *def);

/** Checks that @p def is there and of this library's size. */
TaborStatus tb_check_struct(const TaborDrumDef *def, TaborError *error);

/** Refuses a striker's or microphone's name that is not in @p def, with the nearest that is. */
TaborStatus tb_refuse_name(const TaborDrumDef *def, bool is_mic, const char *key, const char *name,
                           TaborError *error);

#endif /* TABOR_SRC_DEFINITION_H */
