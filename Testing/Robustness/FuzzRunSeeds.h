#ifndef FuzzRunSeeds_h
#define FuzzRunSeeds_h

#include "FuzzSeeds.h"

/** Part of the extension of mutants of these seeds; the name of the file in the run follows, with + for /. */
constexpr const char * RunExtension = ".run+";

/** The files of a virtual colonoscopy folder that its readers parse. Surfaces are rewritten as text and volumes without
 * compression, so that mutations change values instead of checksums; created in `folder`. */
std::vector<FuzzSeed>
MakeRunSeeds(const std::string & exam, const std::string & folder);

/** Reads the run with the file replaced by the mutant, as the tools that read this file do. Returns false if it was
 * rejected with an InputError that names the file; throws std::logic_error if the message does not name it. */
bool
ReadAllOfRun(const std::string & mutant, const std::string & exam);
#endif
