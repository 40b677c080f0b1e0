/* SPDX-License-Identifier: MIT */
#include "lv2/describe_kit.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "lv2/describe_parts.h"
#include "lv2/kit_ports.h"
#include "lv2/turtle.h"
#include "lv2/uris.h"

/* ---- groups --------------------------------------------------------------------------------- */

#define GROUP_SIZE 16

/* The symbol of a group of knobs: its name in small letters. */
static const char *knob_group(const KitKnob *knob, char symbol[GROUP_SIZE]) {
  (void)snprintf(symbol, GROUP_SIZE, "%s", knob->group);
  for (char *letter = symbol; *letter; letter++) *letter = (char)tolower(*letter);
  return symbol;
}

static bool is_first_of_group(uint32_t id) {
  for (uint32_t i = 0; i < id; i++) {
    if (strcmp(kit_knobs[i].group, kit_knobs[id].group) == 0) return false;
  }
  return true;
}

static void put_knob_groups(void) {
  char symbol[GROUP_SIZE];
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    if (!is_first_of_group(i)) continue;
    (void)knob_group(&kit_knobs[i], symbol);
    put("<%s%s>\n\ta pg:InputGroup ;\n\tlv2:symbol \"%s\" ;\n\tlv2:name \"%s\" .\n\n",
        URI_KIT_GROUP, symbol, symbol, kit_knobs[i].group);
  }
}

/* Pair 0 is the mix. */
static void put_pair(uint32_t pair) {
  put("<%sout_%u>\n\ta pg:OutputGroup , pg:StereoGroup ;\n\tlv2:symbol \"out_%u\" ;\n",
      URI_KIT_GROUP, (unsigned)pair, (unsigned)pair);
  if (pair == 0) {
    put("\tlv2:name \"Mix\" .\n\n");
  } else {
    put("\tlv2:name \"Drum %u\" .\n\n", (unsigned)pair);
  }
}

/* ---- files ---------------------------------------------------------------------------------- */

static void put_file_property(void) {
  put("<%s>\n\ta lv2:Parameter ;\n\trdfs:label \"Kit file\" ;\n", URI_KIT_FILE);
  put("\trdfs:comment \"The kit that plays as the user's own: an INI file.\" ;\n");
  put("\trdfs:range atom:Path .\n\n");
}

/* ---- ports ---------------------------------------------------------------------------------- */

static void put_output(uint32_t channel) {
  static const char *const symbols[] = {"left", "right"};
  const uint32_t pair = channel / 2, side = channel % 2;
  put("\t\ta lv2:OutputPort , lv2:AudioPort ;\n");
  if (pair == 0) {
    put("\t\tlv2:symbol \"out_%s\" ;\n\t\tlv2:name \"Mix %s\" ;\n", symbols[side], symbols[side]);
  } else {
    put("\t\tlv2:symbol \"out_%u_%s\" ;\n", (unsigned)pair, symbols[side]);
    put("\t\tlv2:name \"Drum %u %s\" ;\n", (unsigned)pair, symbols[side]);
    put("\t\tlv2:portProperty lv2:connectionOptional ;\n");
  }
  put_side(side);
  put("\t\tpg:group <%sout_%u>\n", URI_KIT_GROUP, (unsigned)pair);
}

static void put_knob(const KitKnob *knob) {
  char group[GROUP_SIZE];
  put("\t\ta lv2:InputPort , lv2:ControlPort ;\n");
  put("\t\tlv2:symbol \"%s\" ;\n\t\tlv2:name \"%s\" ;\n", knob->symbol, knob->name);
  put_range((double)knob->fallback, (double)knob->minimum, (double)knob->maximum);
  put_unit(knob->unit);
  if (knob->rebuilds) put("\t\tlv2:portProperty pprops:expensive ;\n");
  if (knob->choices) put_choices(knob->choices);
  if (knob->off) put_point("Off", 3, (double)knob->minimum);
  if (knob == &kit_knobs[KIT_KNOB_GAIN]) put("\t\tlv2:designation param:gain ;\n");
  put("\t\tpg:group <%s%s>\n", URI_KIT_GROUP, knob_group(knob, group));
}

static void put_port(uint32_t number, Port port) {
  put("%s[\n\t\tlv2:index %u ;\n", number > 0 ? " , " : "\tlv2:port ", (unsigned)number);
  switch (port.kind) {
  case PORT_EVENTS: put_events(true); break;
  case PORT_OUTPUT: put_output(port.index); break;
  case PORT_FREEWHEEL: put_freewheel(); break;
  case PORT_READY: put_ready(); break;
  case PORT_KNOB: put_knob(&kit_knobs[port.index]); break;
  case PORT_INPUT: /* the kit has none */
  case PORT_NONE: break;
  }
  put("\t]");
}

/* ---- the plugin ----------------------------------------------------------------------------- */

static const PluginWords words = {
  .uri = URI_KIT,
  .name = "Tabor Kit",
  .kind = "InstrumentPlugin",
  .brief = "A drum kit computed from physics, an output per drum",
  .comment = "Drums that stand in one room and hear each other: no samples. Notes are those of "
             "General MIDI or of a drum module; each drum has an output, a level and a tuning."};

void put_kit(bool has_window) {
  Port port;
  put_knob_groups();
  for (uint32_t pair = 0; pair <= KIT_KNOB_DRUMS; pair++) put_pair(pair);
  put_file_property();
  put_plugin_words(&words);
  put("\tlv2:extensionData state:interface ;\n\tpatch:writable <%s> ;\n", URI_KIT_FILE);
  if (has_window) put("\tui:ui <%s> ;\n", URI_KIT_WINDOW);
  put("\tlv2:optionalFeature lv2:hardRTCapable , log:log ;\n\tpg:mainOutput <%sout_0> ;\n",
      URI_KIT_GROUP);
  for (uint32_t number = 0; (port = kit_port_at(number)).kind != PORT_NONE; number++) {
    put_port(number, port);
  }
  put(" .\n\n");
}
