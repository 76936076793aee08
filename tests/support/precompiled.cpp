// Holds the precompiled doctest that the tests reuse; test_main.cpp, which implements doctest,
// can't.
