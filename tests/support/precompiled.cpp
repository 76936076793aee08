// Holds the precompiled headers that the tests reuse; test_main.cpp, which implements doctest,
// can't.
