#ifndef shapetonFaultySystem_h
#define shapetonFaultySystem_h

namespace tooltest
{
/** What the calls of the operating system do in this process in place of their work; 0: nothing special. */
struct FaultySystem
{
  int  fsyncError{ 0 };
  int  renameError{ 0 };
  int  callOfRename{ 1 };           ///< the call, counted from 1, that is special
  int  signalAtRename{ 0 };         ///< raised before the work
  bool losesRaceForFolder{ false }; ///< another process makes each folder just before this one
};

extern FaultySystem faultySystem;
} // namespace tooltest

#endif
