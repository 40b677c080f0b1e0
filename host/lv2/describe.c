/* SPDX-License-Identifier: MIT */
/**
 * @file describe.c
 * Writes the plugins' description in Turtle, from the plugins' own tables and the presets.
 *
 *     describe FOLDER BINARY [WINDOW]
 *
 * It writes manifest.ttl, tabor.ttl (the plugins) and presets.ttl (factory presets) to FOLDER.
 * BINARY is the name of the plugins' binary in FOLDER, WINDOW that of their window. The exit status
 * is 1 on failure.
 */
#include <ctype.h>
#include <lv2/instance-access/instance-access.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "lv2/describe_parts.h"
#include "lv2/plugins.h"
#include "lv2/ports.h"
#include "lv2/turtle.h"
#include "plugin/knobs.h"

/* ---- knobs ---------------------------------------------------------------------------------- */

static void put_word(const char *word, double value) { put_point(word, (int)strlen(word), value); }

static void put_knob(const Lv2Plugin *plugin, const Instrument *instrument, uint32_t id) {
  const Knob *const knob = &instrument->kind->knobs[id];
  const KnobRange *const range = &instrument->ranges[id];
  const bool is_expensive =
    knob->kind == KNOB_REBUILD || knob->kind == KNOB_REPLACE || knob->is_costly;
  put("\t\ta lv2:InputPort , lv2:ControlPort ;\n");
  put("\t\tlv2:symbol \"%s\" ;\n\t\tlv2:name \"%s\" ;\n", knob->symbol, knob->name);
  const double minimum = knob_decimal(port_minimum(range));
  put_range(knob_decimal(range->fallback), minimum, knob_decimal(range->maximum));
  put_unit(range->unit);
  if (knob_is_bent(range)) put("\t\tlv2:portProperty pprops:logarithmic ;\n");
  if (is_expensive) put("\t\tlv2:portProperty pprops:expensive ;\n");
  if (knob->choices) put_choices(knob->choices);
  if (!isnan(knob->off)) put_word(knob_off_word(knob), fmax(knob->off, minimum));
  if (knob->top_word) put_word(knob->top_word, knob_decimal(range->maximum));
  if (knob->is_bypass)
    put("\t\tlv2:portProperty lv2:toggled ;\n\t\tlv2:designation lv2:enabled ;\n");
  if (knob->is_gain) put("\t\tlv2:designation param:gain ;\n");
  put("\t\tpg:group <%s%s> ;\n\t\trdfs:comment ", plugin->group, knob->group);
  put_text(knob->comment);
  put("\n");
}

/* ---- sound ---------------------------------------------------------------------------------- */

static const char *const sides[] = {"left", "right"};

static void put_input(uint32_t side) {
  put("\t\ta lv2:InputPort , lv2:AudioPort ;\n");
  put("\t\tlv2:symbol \"in_%s\" ;\n", sides[side]);
  put_side(side);
  put("\t\tlv2:name \"Sound %s\"\n", sides[side]);
}

static const InstrumentOutput *output_of(const InstrumentKind *kind, uint32_t channel) {
  const InstrumentOutput *output = kind->outputs;
  while (channel < output->first || channel >= output->first + output->channels) output++;
  return output;
}

/* Of the group of an output: the first is the pair of a drum, out_0 of a kit, whose others have
 * their numbers. */
static const char *output_symbol(const InstrumentKind *kind, const InstrumentOutput *output,
                                 char symbol[16]) {
  const unsigned number = (unsigned)(output - kind->outputs);
  (void)snprintf(symbol, 16, kind->id == INSTRUMENT_KIT ? "out_%u" : "pair", number);
  return symbol;
}

/* A microphone by its name; the first output by its sides; others by their numbers and sides. */
static void put_channel(const InstrumentKind *kind, const InstrumentOutput *output, uint32_t side) {
  const unsigned number = (unsigned)(output - kind->outputs);
  if (output->channels == 1) {
    put("\t\tlv2:symbol \"out_%c%s\" ;\n", tolower(output->name[0]), output->name + 1);
    put("\t\tlv2:name \"%s\"\n", output->name);
    return;
  }
  if (number == 0) {
    put("\t\tlv2:symbol \"out_%s\" ;\n", sides[side]);
  } else {
    put("\t\tlv2:symbol \"out_%u_%s\" ;\n", number, sides[side]);
  }
  put("\t\tlv2:name \"%s %s\"\n", output->name, sides[side]);
}

static void put_output(const Lv2Plugin *plugin, uint32_t channel) {
  const InstrumentKind *const kind = &instrument_kinds[plugin->kind];
  const InstrumentOutput *const output = output_of(kind, channel);
  const uint32_t side = channel - output->first;
  char symbol[16];
  put("\t\ta lv2:OutputPort , lv2:AudioPort ;\n");
  const bool is_needed = kind->id != INSTRUMENT_MULTI && output == kind->outputs;
  if (!is_needed) put("\t\tlv2:portProperty lv2:connectionOptional ;\n");
  if (output->channels == 2) {
    put_side(side);
    put("\t\tpg:group <%s%s> ;\n", plugin->group, output_symbol(kind, output, symbol));
  }
  put_channel(kind, output, side);
}

static void put_port(const Lv2Plugin *plugin, const Instrument *instrument, uint32_t number) {
  const Port port = port_at(instrument->kind, number);
  put("%s[\n\t\tlv2:index %u ;\n", number > 0 ? " , " : "\tlv2:port ", (unsigned)number);
  switch (port.kind) {
  case PORT_EVENTS: put_events(); break;
  case PORT_INPUT: put_input(port.index); break;
  case PORT_OUTPUT: put_output(plugin, port.index); break;
  case PORT_FREEWHEEL: put_freewheel(); break;
  case PORT_READY: put_ready(); break;
  case PORT_KNOB: put_knob(plugin, instrument, port.index); break;
  case PORT_NONE: break;
  }
  put("\t]");
}

/* ---- plugins -------------------------------------------------------------------------------- */

static bool has_group(const InstrumentKind *kind, const KnobGroup *group) {
  uint32_t id;
  for (uint32_t i = 0; (id = instrument_knob_at(kind, i)) < kind->knob_count; i++) {
    if (strcmp(kind->knobs[id].group, group->symbol) == 0) return true;
  }
  return false;
}

static void put_group(const char *uri, const char *symbol, const char *name, const char *types) {
  put("<%s%s>\n\ta %s ;\n\tlv2:symbol \"%s\" ;\n\tlv2:name \"%s\" .\n\n", uri, symbol, types,
      symbol, name);
}

static void put_groups(const Lv2Plugin *plugin) {
  const InstrumentKind *const kind = &instrument_kinds[plugin->kind];
  char symbol[16];
  for (uint32_t i = 0; i < kind->group_count; i++) {
    const KnobGroup *const group = &kind->groups[i];
    if (has_group(kind, group))
      put_group(plugin->group, group->symbol, group->name, "pg:InputGroup");
  }
  for (uint32_t i = 0; i < kind->output_count; i++) {
    const InstrumentOutput *const output = &kind->outputs[i];
    if (output->channels == 1) continue;
    put_group(plugin->group, output_symbol(kind, output, symbol), output->name,
              "pg:OutputGroup , pg:StereoGroup");
  }
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

static void put_file(const char *uri, const char *what) {
  put("<%s>\n\ta lv2:Parameter ;\n\trdfs:label \"%s file\" ;\n", uri, what);
  put("\trdfs:comment \"The %s that plays as the user's own: an INI file.\" ;\n", what);
  put("\trdfs:range atom:Path .\n\n");
}

static void put_plugin(const Lv2Plugin *plugin, bool has_window) {
  const InstrumentKind *const kind = &instrument_kinds[plugin->kind];
  Instrument *const instrument = instrument_create(kind);
  char symbol[16];
  if (!instrument) turtle_fail("out of memory");
  const PluginWords words = {plugin->uri, kind->name, plugin->type, kind->brief, kind->comment};
  put_plugin_words(&words);
  if (has_window) put("\tui:ui <%s> ;\n", plugin->window);
  put("\tlv2:optionalFeature lv2:hardRTCapable , work:schedule , log:log , "
      "state:threadSafeRestore ;\n"
      "\tlv2:extensionData work:interface , state:interface ;\n"
      "\tpatch:writable <%s> ;\n\tpg:mainOutput <%s%s> ;\n",
      plugin->file, plugin->group, output_symbol(kind, kind->outputs, symbol));
  for (uint32_t number = 0; port_at(kind, number).kind != PORT_NONE; number++)
    put_port(plugin, instrument, number);
  put(" .\n\n");
  instrument_destroy(instrument);
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
  for (size_t i = 0; i < INSTRUMENT_KINDS; i++) {
    put("<%s>\n\ta lv2:Plugin ;\n\tlv2:binary <%s> ;\n\trdfs:seeAlso <tabor.ttl> .\n\n",
        lv2_plugins[i].uri, binary);
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
  put_groups(lv2_plugin_find(URI_EFFECT)); /* the drum that has all groups */
  put_groups(lv2_plugin_find(URI_KIT));
  put_properties();
  put_file(URI_DRUM_FILE, "drum");
  put_file(URI_KIT_FILE, "kit");
  for (size_t i = 0; i < INSTRUMENT_KINDS; i++) put_plugin(&lv2_plugins[i], has_window);
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
  write_manifest(argv[1], argv[2], argv[3]);
  write_plugins(argv[1], argc == 4);
  write_presets(argv[1]);
  return 0;
}
