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
/** Inverts several matrices of one pattern with several threads. The tasks are the subtrees of all matrices in
 * flight, and the trunk of each. Results are independent of the number of threads. Each thread calls Work(), which
 * returns when no tasks are left. Progress is reported by the thread that constructed this object, which must be one of
 * them. */
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
    std::size_t                     next{ 0 };    ///< the next subtree to process
    std::size_t                     running{ 0 }; ///< tasks started but not complete
    AlignedBuffer                   factor;       ///< reused from a completed matrix, or empty
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
  std::atomic<std::size_t> m_Done{ 0 };      ///< completed tasks of all matrices
  std::atomic<bool>        m_Stops{ false }; ///< a worker has failed

  std::mutex              m_Mutex;
  std::condition_variable m_Changed;
  AlignedBuffer           m_SpareFactor;
  std::deque<Flight>      m_Flights; ///< ordered by matrix
  std::exception_ptr      m_Failure;
};
} // namespace shapeton

#endif
