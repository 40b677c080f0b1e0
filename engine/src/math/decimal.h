/* SPDX-License-Identifier: MIT */
/* The double nearest to a decimal number, ties to even: the result of strtod() in the C locale,
 * whatever the current locale.
 *
 * Up to 15 digits with up to 22 zeros are two exact doubles and one operation. All other numbers
 * use whole numbers: digits 10^e = quotient 2^b, divided bit by bit until 64 bits of the quotient
 * are known, and whether there is a remainder. */
#ifndef TB_DECIMAL_H
#define TB_DECIMAL_H

/* `text` must be [+-] digits [. digits] [e [+-] digits] with a digit before the exponent and
 * nothing after. The result is infinite for a too large number, zero for a too small one. */
double tb_decimal_read(const char *text);

#endif
