#ifndef shapetonInversionSchedule_h
#define shapetonInversionSchedule_h

#include "shapetonFrontalInverse.h"
#include "shapetonParallelFor.h"
#include "shapetonSubtreeTasks.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>

namespace shapeton
{
/** Inverts several matrices of one pattern with several threads: subtrees of all matrices in flight are work to be
 * taken, the trunk of each is one piece. What is computed does not depend on who computes it, so the results are the
 * same for any number of threads. Work() is called by each of them and returns when there is nothing left to do.
 * Progress is reported by the thread that has made this, which is to be one of them. */
class InversionSchedule
{
public:
  using MatrixOf = std::function<SymmetricElements(int)>;
  using Take = std::function<void(int, const SymmetricElements &)>;

  InversionSchedule(const Supernodes &   supernodes,
                    const FactorLayout & layout,
                    const SubtreeTasks & tasks,
                    int                  number,
                    int                  atOnce,
                    const MatrixOf &     matrixOf,
                    const Take &         take,
                    const Progress &     progress);
  void
  Work();

private:
  enum class Stage
  {
    Begin,
    Factor,
    Trunk,
    Invert,
    End
  };
  /** A matrix in flight. */
  struct Flight
  {
    int                             matrix;
    Stage                           stage{ Stage::Begin };
    std::size_t                     next{ 0 };    ///< the subtree to be taken
    std::size_t                     running{ 0 }; ///< pieces taken and not done
    AlignedBuffer                   factor;       ///< of a matrix that is done, or none
    std::unique_ptr<FrontalInverse> inverse;
  };

  void
  Step(std::unique_lock<std::mutex> & lock, FrontWorkspace & workspace);
  Flight *
  FindWork();
  std::size_t
  PiecesOf(Stage stage) const;
  void
  RunPiece(Flight & flight, Stage stage, std::size_t piece, FrontWorkspace & workspace);
  void
  RunTrunk(FrontalInverse & inverse, FrontWorkspace & workspace);
  void
  Report();
  void
  Advance(Flight & flight);
  void
  Start();

  const Supernodes &       m_Supernodes;
  const FactorLayout &     m_Layout;
  const SubtreeTasks &     m_Tasks;
  const MatrixOf &         m_MatrixOf;
  const Take &             m_Take;
  const int                m_Number;
  const ProgressOfWorkers  m_Progress;
  int                      m_Started{ 0 };
  std::atomic<std::size_t> m_Done{ 0 };      ///< pieces of all matrices
  std::atomic<bool>        m_Stops{ false }; ///< somebody has failed

  std::mutex              m_Mutex;
  std::condition_variable m_Changed;
  AlignedBuffer           m_SpareFactor;
  std::deque<Flight>      m_Flights; ///< in the order of their matrices
  std::exception_ptr      m_Failure;
};
} // namespace shapeton

#endif
