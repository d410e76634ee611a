#-- # Grading Level Criteria Report
#-- EVALUATION DATE: 2026-11-22
#-- EVALUATORS: the developers of Shapeton
#--
#-- ## Compliance level 5 star (AKA ITK main modules, or remote modules that could become core modules)
#--   - [ ] Widespread community dependance
#--   - [ ] Above 90% code coverage
#--   - [ ] CI dashboards and testing monitored rigorously
#--   - [ ] Key API features are exposed in wrapping interface
#--   - [ ] All requirements of Levels 4,3,2,1
#--
#-- ## Compliance Level 4 star (Very high-quality code, perhaps small community dependance)
#--   - [X] Meets all ITK code style standards
#--   - [ ] No external requirements beyond those needed by ITK proper
#--   - [ ] Builds and passes tests on all supported platforms within 1 month of each core tagged release
#--   - [ ] Active developer community dedicated to maintaining code-base
#--   - [ ] 75% code coverage demonstrated for testing suite
#--   - [X] Continuous integration testing performed
#--   - [ ] All requirements of Levels 3,2,1
#--
#-- ## Compliance Level 3 star (Quality beta code)
#--   - [ ] API | executable interface is considered mostly stable and feature complete
#--   - [X] 10% C0-code coverage demonstrated for testing suite
#--   - [X] Some tests exist and pass on at least some platform
#--   - [X] All requirements of Levels 2,1
#--
#-- ## Compliance Level 2 star (Alpha code feature API development or niche community/execution environment dependance )
#--   - [X] Compiles for at least 1 niche set of execution envirionments, and perhaps others
#--         (may depend on specific external tools like a java environment, or specific external libraries to work )
#--   - [X] All requirements of Levels 1
#--
#-- ## Compliance Level 1 star (Pre-alpha features under development and code of unknown quality)
#--   - [X] Code complies on at least 1 platform
#--
#-- ### Please document here any justification for the criteria above
#       Level 2: Linux only; requires VTK, DCMTK, OpenCV, METIS, nauty, Spectra, SQLite and bzip2

# Shapeton does not have a public address. An existing clone (or a link to one) in Modules/Remote/Shapeton is used as it is;
# otherwise set Shapeton_GIT_REPOSITORY to a clone and ITK's option Module_Shapeton_GIT_TAG to a commit.
itk_fetch_module(
  Shapeton
  "Shape-based analysis of medical volumes: heat and shapeton diffusion, virtual colonoscopy, graphs on surfaces"
  MODULE_COMPLIANCE_LEVEL 2
  GIT_REPOSITORY "${Shapeton_GIT_REPOSITORY}"
)
