"""What the workflow of cohorts is made of; standard library only. See ../README.md."""
