#ifndef shapetonFaultySystem_h
#define shapetonFaultySystem_h

namespace tooltest
{
/** Faults injected into system calls of this process; 0: none. */
struct FaultySystem
{
  int  fsyncError{ 0 };
  int  renameError{ 0 };
  int  callOfRename{ 1 };           ///< number of the faulty call, counted from 1
  int  signalAtRename{ 0 };         ///< raised before the call
  bool losesRaceForFolder{ false }; ///< simulates another process that creates each folder first
};

extern FaultySystem faultySystem;
} // namespace tooltest

#endif
