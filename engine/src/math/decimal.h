/* SPDX-License-Identifier: MIT */
/* The double nearest to a decimal number, ties to even: what strtod() reads in the C locale, without a locale.
 *
 * Up to 15 digits with up to 22 zeros are two exact doubles and one operation. All else goes by whole numbers:
 * digits 10^e = quotient 2^b, divided bit by bit until 64 bits of the quotient are known and whether anything
 * is left over. */
#ifndef TB_DECIMAL_H
#define TB_DECIMAL_H

/* `text` is [+-] digits [. digits] [e [+-] digits] with a digit before the exponent, and ends there. Infinite if
 * it is too large, zero if it is too small. */
double tb_decimal_read(const char *text);

#endif
