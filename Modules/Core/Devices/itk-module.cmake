set(DOCUMENTATION "Where a computation runs, on the CPU or on a GPU: the choice, the plug-in with the kernels of the GPU, and what
these kernels are written with.")

itk_module(Devices
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
