#ifndef shapetonSessionCommands_h
#define shapetonSessionCommands_h

#include "shapetonJson.h"
#include "shapetonParticleDiffusionOptions.h"
#include "shapetonStartRegion.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** The values of a command. All throw ParameterError for a missing key, a wrong type, or a value out of range. */
///@{
/** Throws unless the command is an object with only these keys, "do" and "id". */
void
RequireKeys(const Json & command, const std::vector<std::string> & keys);
double
NumberOf(const Json & command, const std::string & key, double least, double most);
std::uint64_t
CountOf(const Json & command, const std::string & key, std::uint64_t least, std::uint64_t most);
std::string
WordOf(const Json & command, const std::string & key);
bool
FlagOf(const Json & command, const std::string & key);
itk::Point<double, 3>
PointOf(const Json & command, const std::string & key);
/** A list of balls, each x, y, z, radius. */
std::vector<Ball>
BallsOf(const Json & command, const std::string & key);
/** A name for results: letters, digits, "_", "-" and "."; the first is a letter or digit. */
std::string
ResultNameOf(const Json & command, const std::string & key);
///@}

/** Sets the options that the command names. All options of a walk are allowed, except its number of steps. */
void
SetOptions(const Json & command, ParticleDiffusionOptions & options);

/** The current values of the options of the walk. */
Json
JsonOfOptions(const ParticleDiffusionOptions & options);
} // namespace shapeton

#endif
