/* SPDX-License-Identifier: MIT */
#include "lv2/describe_parts.h"

#include <string.h>
#include <tabor/tabor.h>

#include "lv2/turtle.h"

void put_plugin_words(const PluginWords *words) {
  put("<%s>\n\ta lv2:Plugin , lv2:%s , doap:Project ;\n", words->uri, words->kind);
  put("\tdoap:name \"%s\" ;\n", words->name);
  put("\tdoap:license <https://spdx.org/licenses/MIT> ;\n"
      "\tdoap:maintainer [ a foaf:Person ; foaf:name \"Tabor's maintainers\" ] ;\n");
  put("\tdoap:shortdesc \"%s\" ;\n", words->brief);
  put("\trdfs:comment \"%s\" ;\n", words->comment);
  put("\tlv2:minorVersion %d ;\n\tlv2:microVersion %d ;\n", TABOR_VERSION_MINOR,
      TABOR_VERSION_PATCH);
  put("\tlv2:requiredFeature urid:map ;\n");
}

/* ---- lines of a port ------------------------------------------------------------------------ */

void put_range(double fallback, double minimum, double maximum) {
  put("\t\tlv2:default ");
  put_number(fallback);
  put(" ;\n\t\tlv2:minimum ");
  put_number(minimum);
  put(" ;\n\t\tlv2:maximum ");
  put_number(maximum);
  put(" ;\n");
}

void put_unit(const char *unit) {
  static const char *const known[][2] = {{"m", "units:m"},
                                         {"deg", "units:degree"},
                                         {"Hz", "units:hz"},
                                         {"dB", "units:db"},
                                         {"semitones", "units:semitone12TET"}};
  if (!*unit) return;
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    if (strcmp(unit, known[i][0]) == 0) {
      put("\t\tunits:unit %s ;\n", known[i][1]);
      return;
    }
  }
  put("\t\tunits:unit [\n\t\t\ta units:Unit ;\n\t\t\trdfs:label \"%s\" ;\n", unit);
  put("\t\t\tunits:symbol \"%s\" ;\n\t\t\tunits:render \"%%f %s\"\n\t\t] ;\n", unit, unit);
}

void put_point(const char *label, int length, double value) {
  put("\t\tlv2:scalePoint [ rdfs:label \"%.*s\" ; rdf:value ", length, label);
  put_number(value);
  put(" ] ;\n");
}

void put_choices(const char *choices) {
  put("\t\tlv2:portProperty lv2:integer , lv2:enumeration ;\n");
  for (int value = 0; *choices; value++) {
    const int length = (int)strcspn(choices, "|");
    put_point(choices, length, value);
    choices += length + (choices[length] == '|');
  }
}

void put_side(unsigned side) { put("\t\tlv2:designation pg:%s ;\n", side == 0 ? "left" : "right"); }

/* ---- ports ---------------------------------------------------------------------------------- */

void put_events(void) {
  put("\t\ta lv2:InputPort , atom:AtomPort ;\n\t\tatom:bufferType atom:Sequence ;\n");
  put("\t\tatom:supports midi:MidiEvent , patch:Message ;\n");
  put("\t\tlv2:designation lv2:control ;\n"
      "\t\tlv2:symbol \"events\" ;\n\t\tlv2:name \"MIDI\"\n");
}

void put_freewheel(void) {
  put(
    "\t\ta lv2:InputPort , lv2:ControlPort ;\n\t\tlv2:symbol \"freewheel\" ;\n"
    "\t\tlv2:name \"Freewheel\" ;\n\t\tlv2:designation lv2:freeWheeling ;\n"
    "\t\tlv2:default 0.0 ;\n\t\tlv2:minimum 0.0 ;\n\t\tlv2:maximum 1.0 ;\n"
    "\t\tlv2:portProperty lv2:toggled , lv2:connectionOptional , pprops:notOnGUI ;\n"
    "\t\trdfs:comment \"1: the host renders faster than real time, and the drum waits for what has "
    "to be computed.\"\n");
}

void put_ready(void) {
  put(
    "\t\ta lv2:OutputPort , lv2:ControlPort ;\n\t\tlv2:symbol \"ready\" ;\n"
    "\t\tlv2:name \"Ready\" ;\n"
    "\t\tlv2:default 0.0 ;\n\t\tlv2:minimum 0.0 ;\n\t\tlv2:maximum 1.0 ;\n"
    "\t\tlv2:portProperty lv2:toggled , lv2:connectionOptional ;\n"
    "\t\trdfs:comment \"0 while another drum, tuning or quality is being computed; the one before "
    "plays on.\"\n");
}
