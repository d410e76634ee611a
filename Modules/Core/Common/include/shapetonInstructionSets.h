#ifndef shapetonInstructionSets_h
#define shapetonInstructionSets_h

/** Macro expansion as a string literal. */
#define SHAPETON_STRING(text) SHAPETON_STRING_OF(text)
#define SHAPETON_STRING_OF(text) #text

namespace shapeton
{
/** Tags of the instruction sets that kernels are compiled for. A family of kernels is a struct of function pointers,
 *
 * \code
 * struct Set
 * {
 *   const char * name;
 *   void (*Multiply)(...);
 *   static const Set & Compiled(InstructionSets::Baseline);
 *   static const Set & Compiled(InstructionSets::Avx2);
 *   static const Set & Compiled(InstructionSets::Avx512);
 * };
 * \endcode
 *
 * and one source file, which CMake's shapeton_add_kernels() compiles once per instruction set. That file defines
 * Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET), uses vectors of SHAPETON_VECTOR_BYTES, and does not include
 * standard headers, because their inline functions would be compiled for that CPU, too. BestKernels() chooses at run
 * time. All sets of a family perform the same operations in the same order, so results are identical on every CPU. */
namespace InstructionSets
{
struct Baseline
{};
struct Avx2
{};
struct Avx512
{};
} // namespace InstructionSets
} // namespace shapeton

#endif
