#ifndef FuzzGraphSeeds_h
#define FuzzGraphSeeds_h

#include "FuzzSeeds.h"

/** Graphs in all supported formats, and embedding certificates; created in `folder`. */
std::vector<FuzzSeed>
MakeGraphSeeds(const std::string & folder);
#endif
