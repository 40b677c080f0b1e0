/* SPDX-License-Identifier: MIT */
/* Each contact has a row. The rows of the wires' contact points come first, TbWires.stride of them.
 * The rows of the slots follow; a slot is a place in the striker pool for a striker, hand or
 * muffler. */
#ifndef TB_CONTACT_ROWS_H
#define TB_CONTACT_ROWS_H

/* Slots: strikers and hands, then a muffler for each head; a multiple of 8. */
#define TB_SLOTS 16u

/* Penetration of an unused row [m]. An unused row never touches, so loops may run over it. */
#define TB_NOTHING (-1e3)

#endif
