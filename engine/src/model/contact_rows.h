/* SPDX-License-Identifier: MIT */
/* Contacts stand in rows: the wires' contact points first, TbWires.stride of them, then the slots of strikers, hands
 * and mufflers. */
#ifndef TB_CONTACT_ROWS_H
#define TB_CONTACT_ROWS_H

/* Strikers and hands, then a muffler for each head; a multiple of 8. */
#define TB_SLOTS 16u

/* Penetration of a row that stands for nothing [m]: loops may run over it, and it never touches. */
#define TB_NOTHING (-1e3)

#endif
