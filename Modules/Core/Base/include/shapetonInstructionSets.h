#ifndef shapetonInstructionSets_h
#define shapetonInstructionSets_h

/** The words of a macro as a string. */
#define SHAPETON_STRING(text) SHAPETON_STRING_OF(text)
#define SHAPETON_STRING_OF(text) #text

namespace shapeton
{
/** The instruction sets that kernels are compiled for, as tags. A family of kernels is a struct of function pointers,
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
 * and one source file, which CMake's shapeton_add_kernels() compiles once for each instruction set. That file defines
 * Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET), has SHAPETON_VECTOR_BYTES in a vector, and includes no standard
 * library, whose inline functions would be compiled for that CPU, too. BestKernels() chooses when the program runs. All
 * sets of a family do the same operations in the same order, so that every CPU gives the same bytes. */
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
