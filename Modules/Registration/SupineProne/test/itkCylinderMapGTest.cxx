#include "itkCylinderMap.h"
#include <gtest/gtest.h>
