/* SPDX-License-Identifier: MIT */
/**
 * @file strike.cpp
 * A stroke into a WAV file, from C++: strike FILE.wav [PRESET]
 *
 * Halfway it saves the drum, and another drum on the same model goes on from there: the sound is the
 * same to the last bit as of one drum.
 */
#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "../wav.h"
#include "tabor.hpp"

namespace {

constexpr uint32_t rate = 48000;

std::vector<float> play(const tabor::Definition &definition) {
  const tabor::Model model(definition, rate);
  std::vector<float> sound(rate);
  tabor::Drum first(model);
  first.process({definition.stroke()}, sound.data(), rate / 2);
  tabor::Drum second(model);
  second.load(first.save());
  second.process({}, sound.data() + rate / 2, rate / 2);

  const TaborLedger ledger = second.ledger();
  std::cout << "of " << ledger.injected << " J " << ledger.radiated << " J became sound; residual "
            << ledger.residual << " J\n";
  return sound;
}

} // namespace

int main(int argc, char **argv) try {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: strike FILE.wav [PRESET]\n";
    return 2;
  }
  const std::vector<float> sound = play(tabor::Definition(argc > 2 ? argv[2] : "snare-14x5.5"));
  if (wav_write(argv[1], rate, sound.data(), static_cast<uint32_t>(sound.size()))) return 0;
  std::cerr << "strike: cannot write " << argv[1] << '\n';
  return 1;
} catch (const std::exception &error) {
  std::cerr << "strike: " << error.what() << '\n';
  return 1;
}
