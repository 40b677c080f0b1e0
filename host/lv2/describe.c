/* SPDX-License-Identifier: MIT */
/**
 * @file describe.c
 * Writes the plugins' description in Turtle, from the plugins' own tables and the presets.
 *
 *     describe FOLDER BINARY [WINDOW]
 *
 * It writes manifest.ttl, tabor.ttl (the plugins) and presets.ttl (factory presets) to FOLDER. BINARY is the
 * name of the plugins' binary in FOLDER, WINDOW that of their window. The exit status is 1 on failure.
 */
#include <ctype.h>
#include <lv2/instance-access/instance-access.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "lv2/describe_kit.h"
#include "lv2/describe_parts.h"
#include "lv2/ports.h"
#include "lv2/turtle.h"
#include "lv2/uris.h"

static TaborDrumDef usual;

/* ---- knobs ---------------------------------------------------------------------------------- */

static void put_word(const char *word, double value) { put_point(word, (int)strlen(word), value); }

static void put_knob(KnobSet set, KnobId id) {
  const Knob *const knob = &knobs[id];
  const KnobRange range = knob_range_in(set, id, &usual);
  put("\t\ta lv2:InputPort , lv2:ControlPort ;\n");
  put("\t\tlv2:symbol \"%s\" ;\n\t\tlv2:name \"%s\" ;\n", knob->symbol, knob->name);
  const double minimum = knob_decimal(port_minimum(&range));
  put_range(knob_decimal(range.fallback), minimum, knob_decimal(range.maximum));
  put_unit(range.unit);
  if (knob_is_bent(&range)) put("\t\tlv2:portProperty pprops:logarithmic ;\n");
  if (knob->kind == KNOB_REBUILD || id == KNOB_QUALITY) {
    put("\t\tlv2:portProperty pprops:expensive ;\n");
  }
  if (knob->choices) put_choices(knob->choices);
  if (!isnan(knob->off)) put_word(knob_off_word(knob), fmax(knob->off, minimum));
  if (knob->top_word) put_word(knob->top_word, knob_decimal(range.maximum));
  if (id == KNOB_ENABLED)
    put("\t\tlv2:portProperty lv2:toggled ;\n\t\tlv2:designation lv2:enabled ;\n");
  if (id == KNOB_GAIN) put("\t\tlv2:designation param:gain ;\n");
  put("\t\tpg:group <%s%s> ;\n\t\trdfs:comment ", URI_GROUP, knob->group);
  put_text(knob->comment);
  put("\n");
}

/* ---- other ports ---------------------------------------------------------------------------- */

static void put_input(uint32_t side) {
  static const char *const names[] = {"Left", "Right"};
  put("\t\ta lv2:InputPort , lv2:AudioPort ;\n");
  put("\t\tlv2:symbol \"in_%c%s\" ;\n", tolower(names[side][0]), names[side] + 1);
  put_side(side);
  put("\t\tlv2:name \"Sound %s\"\n", names[side]);
}

static void put_output(bool stereo, uint32_t channel) {
  static const char *const names[] = {"Top", "Bottom", "Near", "Far", "Left", "Right", "Inside"};
  const uint32_t first_side = stereo ? 0 : 4;
  const char *const name = names[stereo ? channel + 4 : channel];
  put("\t\ta lv2:OutputPort , lv2:AudioPort ;\n");
  put("\t\tlv2:symbol \"out_%c%s\" ;\n", tolower(name[0]), name + 1);
  if (!stereo) put("\t\tlv2:portProperty lv2:connectionOptional ;\n");
  if (channel == first_side || channel == first_side + 1) {
    put_side(channel - first_side);
    put("\t\tpg:group <%spair> ;\n", URI_GROUP);
  }
  put("\t\tlv2:name \"%s\"\n", name);
}

static void put_port(KnobSet set, uint32_t number, Port port) {
  put("%s[\n\t\tlv2:index %u ;\n", number > 0 ? " , " : "\tlv2:port ", (unsigned)number);
  switch (port.kind) {
  case PORT_EVENTS: put_events(false); break;
  case PORT_INPUT: put_input(port.index); break;
  case PORT_OUTPUT: put_output(set != KNOBS_MULTI, port.index); break;
  case PORT_FREEWHEEL: put_freewheel(); break;
  case PORT_READY: put_ready(); break;
  case PORT_KNOB: put_knob(set, (KnobId)port.index); break;
  case PORT_NONE: break;
  }
  put("\t]");
}

/* ---- plugins -------------------------------------------------------------------------------- */

/* Whether a plugin has a knob of the group. */
static bool is_used(const KnobGroup *group) {
  KnobId id;
  for (uint32_t i = 0; (id = knob_at(KNOBS_EFFECT, i)) < KNOB_COUNT; i++) {
    if (strcmp(knobs[id].group, group->symbol) == 0) return true;
  }
  return false;
}

static void put_groups(void) {
  for (uint32_t i = 0; i < KNOB_GROUPS; i++) {
    const KnobGroup *const group = &knob_groups[i];
    if (!is_used(group)) continue;
    put("<%s%s>\n\ta pg:InputGroup ;\n\tlv2:symbol \"%s\" ;\n\tlv2:name \"%s\" .\n\n", URI_GROUP,
        group->symbol, group->symbol, group->name);
  }
  put("<%spair>\n\ta pg:OutputGroup , pg:StereoGroup ;\n\tlv2:symbol \"pair\" ;\n"
      "\tlv2:name \"Stereo pair\" .\n\n",
      URI_GROUP);
}

static void put_property(const char *uri, const char *name, const char *label, const char *range) {
  put("<%s%s>\n\ta rdf:Property , owl:DatatypeProperty ;\n\trdfs:label \"%s\" ;\n"
      "\trdfs:range xsd:%s .\n\n",
      uri, name, label, range);
}

/* What stands in states. */
static void put_properties(void) {
  put_property(URI_STATE_VERSION, "", "version of the state", "int");
  put_property(URI_STATE_DEFINITION, "", "definition of the drum", "string");
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    put_property(URI_STATE_CONTROL, knobs[i].symbol, knobs[i].name, "float");
  }
}

#define COMMENT                                                                                    \
  "Heads that move air, wires that bounce on them, a stick that strikes: no samples. Notes 36 to " \
  "50 are strokes; controllers 16 and 17 move the place, 20 the strainer; program changes choose " \
  "drums."

static const PluginWords words[] = {
  [KNOBS_STEREO] = {URI_DRUM, "Tabor", "InstrumentPlugin", "A snare drum computed from physics",
                    COMMENT},
  [KNOBS_MULTI] = {URI_DRUM_MULTI, "Tabor Multi", "InstrumentPlugin",
                   "A snare drum computed from physics, an output per microphone", COMMENT},
  [KNOBS_EFFECT] = {
    URI_EFFECT, "Tabor Rattle", "SimulatorPlugin",
    "A loudspeaker plays the sound to a snare drum, whose snares rattle",
    "What comes in drives the heads as sound does, the snares with them. " COMMENT}};

static void put_plugin(KnobSet set, bool has_window) {
  put_plugin_words(&words[set]);
  if (has_window) put("\tui:ui <%s> ;\n", URI_WINDOW);
  put("\tlv2:optionalFeature lv2:hardRTCapable , work:schedule , log:log , "
      "state:threadSafeRestore ;\n"
      "\tlv2:extensionData work:interface , state:interface ;\n"
      "\tpg:mainOutput <%spair> ;\n",
      URI_GROUP);
  Port port;
  for (uint32_t number = 0; (port = port_at(set, number)).kind != PORT_NONE; number++) {
    put_port(set, number, port);
  }
  put(" .\n\n");
}

/* ---- presets -------------------------------------------------------------------------------- */

static void put_preset_header(const TaborPresetInfo *preset) {
  put("<%s%s>\n\ta pset:Preset ;\n\tlv2:appliesTo <%s> , <%s> ;\n\trdfs:label ", URI_PRESET,
      preset->name, URI_DRUM, URI_DRUM_MULTI);
  put_text(preset->name);
  put(" ;\n\trdfs:comment ");
  put_text(preset->comment);
}

/* Of a drum that is without the part, nothing. */
static void put_preset_port(KnobId id, double value, bool *first) {
  if (isnan(value)) return;
  put("%s[ lv2:symbol \"%s\" ; pset:value ", *first ? " ;\n\tlv2:port " : " ,\n\t\t",
      knobs[id].symbol);
  put_number(fmax(value, knobs[id].least));
  put(" ]");
  *first = false;
}

static void put_preset_state(const TaborDrumDef *def, const double values[KNOB_SEEN]) {
  char *const text = definition_write(def, TABOR_TEXT_KEEP, NULL, NULL);
  if (!text) turtle_fail("out of memory");
  put(" ;\n\tstate:state [\n\t\t<%s> \"%d\"^^xsd:int ;\n\t\t<%s> ", URI_STATE_VERSION,
      STATE_VERSION, URI_STATE_DEFINITION);
  put_text(text);
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    if (isnan(values[i])) continue;
    put(" ;\n\t\t<%s%s> \"", URI_STATE_CONTROL, knobs[i].symbol);
    put_number(values[i]);
    put("\"^^xsd:float");
  }
  put("\n\t] .\n\n");
  free(text);
}

static void put_preset(const TaborPresetInfo *preset) {
  TaborDrumDef def;
  double values[KNOB_SEEN];
  bool first = true;
  if (tabor_drum_def_preset(&def, preset->name, NULL) != TABOR_OK) turtle_fail(preset->name);
  put_preset_header(preset);
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    values[i] = knob_shown(&def, (KnobId)i);
    put_preset_port((KnobId)i, values[i], &first);
  }
  put_preset_state(&def, values);
}

/* ---- files ---------------------------------------------------------------------------------- */

/* It looks into the instance (ui.c), so both have to be in one process. */
static void put_window(const char *uri, const char *binary) {
  put("<%s>\n\ta ui:X11UI ;\n\tlv2:binary <%s> ;\n"
      "\tlv2:requiredFeature ui:parent , ui:idleInterface , <%s> ;\n"
      "\tlv2:optionalFeature ui:resize , ui:touch , urid:map , opts:options ;\n"
      "\tlv2:extensionData ui:idleInterface , ui:resize .\n\n",
      uri, binary, LV2_INSTANCE_ACCESS_URI);
}

static void write_manifest(const char *folder, const char *binary, const char *window) {
  turtle_open(folder, "manifest.ttl");
  put("@prefix lv2: <http://lv2plug.in/ns/lv2core#> .\n"
      "@prefix opts: <http://lv2plug.in/ns/ext/options#> .\n"
      "@prefix ui: <http://lv2plug.in/ns/extensions/ui#> .\n"
      "@prefix urid: <http://lv2plug.in/ns/ext/urid#> .\n"
      "@prefix pset: <http://lv2plug.in/ns/ext/presets#> .\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n\n");
  const char *const uris[] = {URI_DRUM, URI_DRUM_MULTI, URI_KIT, URI_EFFECT};
  for (size_t i = 0; i < sizeof uris / sizeof uris[0]; i++) {
    put("<%s>\n\ta lv2:Plugin ;\n\tlv2:binary <%s> ;\n\trdfs:seeAlso <tabor.ttl> .\n\n", uris[i],
        binary);
  }
  if (window) {
    put_window(URI_WINDOW, window);
    put_window(URI_KIT_WINDOW, window);
  }
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    put_preset_header(tabor_preset(i));
    put(" ;\n\trdfs:seeAlso <presets.ttl> .\n\n");
  }
  turtle_close();
}

static void write_plugins(const char *folder, bool has_window) {
  turtle_open(folder, "tabor.ttl");
  put_prefixes();
  put_groups();
  put_properties();
  put_plugin(KNOBS_STEREO, has_window);
  put_plugin(KNOBS_MULTI, has_window);
  put_plugin(KNOBS_EFFECT, has_window);
  put_kit(has_window);
  turtle_close();
}

static void write_presets(const char *folder) {
  turtle_open(folder, "presets.ttl");
  put_prefixes();
  for (uint32_t i = 0; i < tabor_preset_count(); i++) put_preset(tabor_preset(i));
  turtle_close();
}

int main(int argc, char **argv) {
  if (argc != 3 && argc != 4) turtle_fail("describe FOLDER BINARY [WINDOW]");
  if (tabor_drum_def_preset(&usual, DEFAULT_PRESET, NULL) != TABOR_OK) turtle_fail(DEFAULT_PRESET);
  write_manifest(argv[1], argv[2], argv[3]);
  write_plugins(argv[1], argc == 4);
  write_presets(argv[1]);
  return 0;
}
