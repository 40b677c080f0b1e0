/* SPDX-License-Identifier: MIT */
/* Writes moduleinfo.json for a VST3 bundle, from what the plugins in it say of themselves. A host that reads it need
   not load them to list them.

   vst3-describe BUNDLE OUTPUT */
#include <fstream>
#include <iostream>

#include "public.sdk/source/vst/moduleinfo/moduleinfocreator.h"

int main(int count, char **words) {
  if (count != 3) {
    std::cerr << "usage: vst3-describe BUNDLE OUTPUT\n";
    return 2;
  }
  std::string error;
  const auto module = VST3::Hosting::Module::create(words[1], error);
  if (!module) {
    std::cerr << "vst3-describe: " << error << "\n";
    return 1;
  }
  auto info = Steinberg::ModuleInfoLib::createModuleInfo(*module, false);
  if (!info.classes.empty()) info.version = info.classes.front().version;
  std::ofstream output(words[2]);
  Steinberg::ModuleInfoLib::outputJson(info, output);
  output.close();
  if (!output) std::cerr << "vst3-describe: cannot write " << words[2] << "\n";
  return output ? 0 : 1;
}
