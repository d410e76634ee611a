#ifndef AdjustedRandIndex_h
#define AdjustedRandIndex_h

#include <map>

/** Agreement of two partitions, from the number of members of each pair of their parts: 1 for identical partitions, 0
 * on average for random ones (Hubert and Arabie 1985); 0 if one has a single part. */
double
AdjustedRandIndex(const std::map<int, std::map<int, double>> & members);

#endif
