# Tests that take more than one process: ranks, a server, a second session. Included by CMakeLists.txt.
find_program(RTGLYPHS_PVBATCH pvbatch HINTS "${ParaView_PREFIX_PATH}/bin" NO_DEFAULT_PATH)
find_program(RTGLYPHS_PVBATCH pvbatch)
find_program(RTGLYPHS_PVSERVER pvserver HINTS "${ParaView_PREFIX_PATH}/bin" NO_DEFAULT_PATH)
find_program(RTGLYPHS_PVSERVER pvserver)
find_program(RTGLYPHS_MPIEXEC mpiexec)

# Open MPI refuses by default to start more ranks than cores, and to run as root, which it is in a container.
set(mpi_environment
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "OMPI_MCA_mpi_yield_when_idle=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe" # Open MPI 5
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")

if (PARAVIEW_USE_MPI AND RTGLYPHS_MPIEXEC)
  add_library(SleepingRanks MODULE SleepingRanks.cxx)
  rtglyphs_warnings(SleepingRanks)
  set(mpiexec env "LD_PRELOAD=$<TARGET_FILE:SleepingRanks>" "${RTGLYPHS_MPIEXEC}")
endif ()

if (PARAVIEW_USE_MPI AND RTGLYPHS_PVBATCH AND RTGLYPHS_MPIEXEC)
  # One rank makes the pictures that the others are compared with. Four take long on few cores.
  foreach (ranks IN ITEMS 1 2 4)
    rtglyphs_regression_test("Parallel${ranks}" ENVIRONMENT ${mpi_environment}
      COMMAND ${mpiexec} -n "${ranks}" "${RTGLYPHS_PVBATCH}" "${regression}/parallel.py" "${data}")
    set_tests_properties("Parallel${ranks}" PROPERTIES PASS_REGULAR_EXPRESSION "PARALLEL TEST PASSED")
  endforeach ()
  set_tests_properties(Parallel4 PROPERTIES LABELS "regression;long" TIMEOUT 3600)
  rtglyphs_regression_test(ScaleGuessOnRanks ENVIRONMENT ${mpi_environment}
    COMMAND ${mpiexec} -n 3 "${RTGLYPHS_PVBATCH}" "${regression}/scale_guess.py" ranks)
  set_tests_properties(ScaleGuessOnRanks PROPERTIES PASS_REGULAR_EXPRESSION "SCALE GUESS TEST PASSED")
  # ParaView may be built without Catalyst.
  if (TARGET ParaView::PythonCatalyst)
    rtglyphs_regression_test(InSitu ENVIRONMENT ${mpi_environment}
      COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/in_situ.py" ${mpiexec} -n 2 "${RTGLYPHS_PVBATCH}")
  endif ()
  # What was freed goes back to the system, so that limits are reached.
  rtglyphs_regression_test(MemoryLimitOnRanks ENVIRONMENT ${mpi_environment} "GLIBC_TUNABLES=glibc.malloc.mmap_threshold=65536:glibc.malloc.arena_max=1"
    COMMAND ${mpiexec} -n 2 "${RTGLYPHS_PVBATCH}" "${regression}/memory_limit.py" ranks)
  set_tests_properties(MemoryLimitOnRanks PROPERTIES PASS_REGULAR_EXPRESSION "[\n]0 failures")
  set_tests_properties(Parallel1 PROPERTIES FIXTURES_SETUP one_rank)
  set_property(TEST Parallel2 Parallel4 APPEND PROPERTY FIXTURES_REQUIRED one_rank)
else ()
  message(STATUS "No tests of several ranks: they need a ParaView with MPI, pvbatch and mpiexec")
endif ()

if (RTGLYPHS_PVSERVER)
  rtglyphs_regression_test(ClientServer
    COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/client_server.py" "${data}" "${RTGLYPHS_PVSERVER}")
  if (PARAVIEW_USE_MPI AND RTGLYPHS_MPIEXEC)
    rtglyphs_regression_test(ScaleGuessOnServer ENVIRONMENT ${mpi_environment}
      COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/scale_guess.py" server "${RTGLYPHS_PVSERVER}" ${mpiexec} -n 2)
    rtglyphs_regression_test(ClientServer2 ENVIRONMENT ${mpi_environment}
      COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/client_server.py" "${data}" "${RTGLYPHS_PVSERVER}"
        ${mpiexec} -n 2)
    rtglyphs_regression_test(KilledRank ENVIRONMENT ${mpi_environment}
      COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/killed_rank.py" "${RTGLYPHS_PVPYTHON}" "${RTGLYPHS_PVBATCH}" "${RTGLYPHS_PVSERVER}"
        ${mpiexec} -n 2)
  endif ()
else ()
  message(STATUS "No tests of a server: pvserver was not found")
endif ()

# A session that saves, and a fresh one for each of the two ways back.
foreach (step IN ITEMS save state trace)
  rtglyphs_regression_test("State-${step}"
    COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/state_and_trace.py" "${step}")
endforeach ()
set_tests_properties(State-save PROPERTIES FIXTURES_SETUP saved_state)
set_property(TEST State-state State-trace APPEND PROPERTY FIXTURES_REQUIRED saved_state)
