#ifndef FuzzGraphSeeds_h
#define FuzzGraphSeeds_h

#include "FuzzSeeds.h"

/** Graphs in all supported formats, and embedding certificates. */
std::vector<FuzzSeed>
MakeGraphSeeds();
#endif
