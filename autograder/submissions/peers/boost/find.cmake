find_path(BOOST_INCLUDE boost/random/sobol.hpp)
if(BOOST_INCLUDE)
  set(PEER_FOUND ON)
endif()
