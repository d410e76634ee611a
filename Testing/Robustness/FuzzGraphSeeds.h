#ifndef FuzzGraphSeeds_h
#define FuzzGraphSeeds_h

#include "FuzzSeeds.h"

/** Graphs in all formats that are read, and certificates of embeddings. */
std::vector<FuzzSeed>
MakeGraphSeeds();
#endif
