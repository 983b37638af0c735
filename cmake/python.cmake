# Finds what the Python module is built with. MIXCMP_BUILD_PYTHON says whether it is built: AUTO leaves
# it out where something is missing and says so, ON makes that an error.
set(MIXCMP_PYTHON AUTO CACHE STRING "Build the Python module: AUTO, ON or OFF")
set_property(CACHE MIXCMP_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(MIXCMP_BUILD_PYTHON OFF)
if(MIXCMP_PYTHON STREQUAL "OFF")
  return()
endif()

# Debian's interpreter, of which python3-numpy and python3-dev are; -DPython_EXECUTABLE=... takes
# another, with its own.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
if(Python_FOUND)
  # It sets Python_FOUND again, by a search of its own without NumPy.
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
if(pybind11_FOUND)
  set(MIXCMP_BUILD_PYTHON ON)
elseif(MIXCMP_PYTHON STREQUAL "ON")
  message(FATAL_ERROR "The Python module needs python3-dev, python3-numpy and pybind11-dev")
else()
  message(STATUS
          "Python module left out: it needs python3-dev, python3-numpy and pybind11-dev")
endif()
